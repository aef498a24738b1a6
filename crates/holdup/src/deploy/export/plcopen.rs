//! The Structured Text in the exchange format of PLC programming systems: PLCopen XML, TC6 version 2.01.
//!
//! Element names and their order are those of the schema `http://www.plcopen.org/xml/tc6_0201`. The XML is made from the
//! text of the function block, so the two cannot differ: declarations become elements, bodies stay text.

use super::{Export, Language, st};

pub(super) const LANGUAGE: Language = Language {
    id: "plcopen",
    title: "the same function block as PLCopen XML (TC6 2.01)",
    extension: "xml",
    write,
};

/// The schema wants a date; a fixed one gives the same file for the same controller.
const CREATED: &str = "2000-01-01T00:00:00";

fn write(export: &Export) -> String {
    let source = st::write(export);
    let units = units(&source);
    let types: String = units.iter().filter(|unit| unit.kind == Kind::Type).map(data_type).collect();
    let pous: String = units.iter().filter(|unit| unit.kind != Kind::Type).map(pou).collect();
    let scaling = ["fbd", "ld", "sfc"]
        .map(|language| format!("<{language}><scaling x=\"1\" y=\"1\"/></{language}>"))
        .concat();
    let header =
        source.strip_prefix("(*").and_then(|rest| rest.split_once("*)")).map_or("", |(text, _)| text);
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
         <project xmlns=\"http://www.plcopen.org/xml/tc6_0201\">\n\
         <fileHeader companyName=\"holdup\" productName=\"holdup\" productVersion=\"{}\" creationDateTime=\"{CREATED}\"/>\n\
         <contentHeader name=\"{}\"><Comment>{}</Comment>\
         <coordinateInfo>{scaling}</coordinateInfo></contentHeader>\n\
         <types>\n<dataTypes>\n{types}</dataTypes>\n<pous>\n{pous}</pous>\n</types>\n\
         <instances><configurations/></instances>\n\
         </project>\n",
        env!("CARGO_PKG_VERSION"),
        export.name,
        escaped(header)
    )
}

/// What a declaration declares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Type,
    Function,
    FunctionBlock,
}

/// One type, function or function block of the text.
#[derive(Debug)]
struct Unit<'t> {
    kind: Kind,
    name: &'t str,
    /// The type of what a function returns.
    result: Option<&'t str>,
    /// The comment before it.
    documentation: String,
    /// Lists of variables, each under its line `VAR…`, in their order.
    lists: Vec<(&'t str, Vec<Variable<'t>>)>,
    body: Vec<&'t str>,
}

/// A declared variable.
#[derive(Debug)]
struct Variable<'t> {
    name: &'t str,
    of: &'t str,
    initial: Option<&'t str>,
    documentation: Option<&'t str>,
}

/// Takes the text apart. It is the text of our own templates: one declaration a line.
fn units(source: &str) -> Vec<Unit<'_>> {
    let mut units: Vec<Unit> = Vec::new();
    let mut open: Option<Unit> = None;
    let mut comment: Vec<&str> = Vec::new();
    let mut commenting = false;
    let mut declaring = false;
    for line in source.lines() {
        let words = line.trim();
        if let Some(unit) = &mut open {
            if matches!(words, "END_TYPE" | "END_FUNCTION" | "END_FUNCTION_BLOCK") {
                units.extend(open.take());
            } else if matches!(words, "END_VAR" | "END_STRUCT") {
                declaring = false;
            } else if words == "STRUCT" || (words.starts_with("VAR") && unit.body.is_empty()) {
                unit.lists.push((words, Vec::new()));
                declaring = true;
            } else if declaring {
                if let (Some((_, list)), Some(variable)) = (unit.lists.last_mut(), variable(words)) {
                    list.push(variable);
                }
            } else {
                unit.body.push(line);
            }
            continue;
        }
        if words.starts_with("(*") {
            comment.clear();
            commenting = true;
        }
        if commenting {
            comment.push(words.trim_start_matches("(*").trim_end_matches("*)").trim());
            commenting = !words.ends_with("*)");
            continue;
        }
        open = opened(words, &comment);
        if open.is_some() {
            comment.clear();
        }
    }
    units
}

/// The unit that a line begins.
fn opened<'t>(line: &'t str, comment: &[&str]) -> Option<Unit<'t>> {
    let (keyword, rest) = line.split_once(' ')?;
    let (name, result) =
        rest.split_once(" :").map_or((rest, None), |(name, result)| (name, Some(result.trim())));
    let kind = match keyword {
        "TYPE" => Kind::Type,
        "FUNCTION" => Kind::Function,
        "FUNCTION_BLOCK" => Kind::FunctionBlock,
        _ => return None,
    };
    let documentation = comment.join(" ").trim().to_owned();
    Some(Unit { kind, name, result, documentation, lists: Vec::new(), body: Vec::new() })
}

/// `name : TYPE := initial; (* documentation *)`
fn variable(line: &str) -> Option<Variable<'_>> {
    let (declaration, comment) = line.split_once(';')?;
    let (name, rest) = declaration.split_once(" : ")?;
    let (of, initial) = rest.split_once(" := ").map_or((rest, None), |(of, initial)| (of, Some(initial)));
    let documentation =
        comment.trim().strip_prefix("(*").and_then(|rest| rest.strip_suffix("*)")).map(str::trim);
    Some(Variable { name, of, initial, documentation })
}

fn data_type(unit: &Unit) -> String {
    let fields: String = unit.lists.iter().flat_map(|(_, list)| list).map(variable_element).collect();
    format!(
        "<dataType name=\"{}\">\n<baseType><struct>\n{fields}</struct></baseType>\n{}</dataType>\n",
        unit.name,
        documentation(&unit.documentation)
    )
}

fn pou(unit: &Unit) -> String {
    let pou_type = if unit.kind == Kind::Function { "function" } else { "functionBlock" };
    let result =
        unit.result.map_or(String::new(), |of| format!("<returnType>{}</returnType>\n", type_element(of)));
    let mut lists = String::new();
    for (keyword, list) in &unit.lists {
        let (element, attribute) = match *keyword {
            "VAR_INPUT" => ("inputVars", ""),
            "VAR_OUTPUT" => ("outputVars", ""),
            "VAR_IN_OUT" => ("inOutVars", ""),
            "VAR CONSTANT" => ("localVars", " constant=\"true\""),
            _ => ("localVars", ""),
        };
        let variables: String = list.iter().map(variable_element).collect();
        lists += &format!("<{element}{attribute}>\n{variables}</{element}>\n");
    }
    format!(
        "<pou name=\"{}\" pouType=\"{pou_type}\">\n<interface>\n{result}{lists}</interface>\n\
         <body><ST><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">{}\n</xhtml></ST></body>\n{}</pou>\n",
        unit.name,
        escaped(&unit.body.join("\n")),
        documentation(&unit.documentation)
    )
}

fn variable_element(variable: &Variable) -> String {
    let initial = variable.initial.map_or(String::new(), |value| {
        format!("<initialValue><simpleValue value=\"{}\"/></initialValue>", escaped(value))
    });
    format!(
        "<variable name=\"{}\"><type>{}</type>{initial}{}</variable>\n",
        variable.name,
        type_element(variable.of),
        variable.documentation.map_or(String::new(), documentation).trim_end()
    )
}

fn type_element(of: &str) -> String {
    let array = of.strip_prefix("ARRAY[").and_then(|rest| rest.split_once("] OF "));
    if let Some((range, element)) = array
        && let Some((lower, upper)) = range.split_once("..")
    {
        let element = type_element(element);
        return format!(
            "<array><dimension lower=\"{lower}\" upper=\"{upper}\"/><baseType>{element}</baseType></array>"
        );
    }
    match of {
        "BOOL" | "INT" | "DINT" | "REAL" | "LREAL" => format!("<{of}/>"),
        derived => format!("<derived name=\"{derived}\"/>"),
    }
}

fn documentation(text: &str) -> String {
    if text.is_empty() {
        return String::new();
    }
    format!(
        "<documentation><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">{}</xhtml></documentation>\n",
        escaped(text)
    )
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
