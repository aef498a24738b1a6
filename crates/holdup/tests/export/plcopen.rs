//! The PLCopen XML: well-formed, the elements of TC6 2.01, and the very program of the Structured Text.

use holdup::deploy::export::{Float, language};
use roxmltree::{Document, Node};

use crate::sources::{LOOPS, export};

const TC6: &str = "http://www.plcopen.org/xml/tc6_0201";
const XHTML: &str = "http://www.w3.org/1999/xhtml";

/// Each element, and the elements that may stand in it, in this order: the part of the schema that is used.
const SCHEMA: [(&str, &[&str]); 34] = [
    ("project", &["fileHeader", "contentHeader", "types", "instances"]),
    ("fileHeader", &[]),
    ("contentHeader", &["Comment", "coordinateInfo"]),
    ("Comment", &[]),
    ("coordinateInfo", &["fbd", "ld", "sfc"]),
    ("fbd", &["scaling"]),
    ("ld", &["scaling"]),
    ("sfc", &["scaling"]),
    ("scaling", &[]),
    ("types", &["dataTypes", "pous"]),
    ("dataTypes", &["dataType"]),
    ("dataType", &["baseType", "documentation"]),
    ("baseType", &["struct", "BOOL", "INT", "DINT", "REAL", "LREAL", "derived"]),
    ("struct", &["variable"]),
    ("variable", &["type", "initialValue", "documentation"]),
    ("type", &["BOOL", "INT", "DINT", "REAL", "LREAL", "array", "derived"]),
    ("array", &["dimension", "baseType"]),
    ("dimension", &[]),
    ("initialValue", &["simpleValue"]),
    ("simpleValue", &[]),
    ("derived", &[]),
    ("BOOL", &[]),
    ("INT", &[]),
    ("DINT", &[]),
    ("LREAL", &[]),
    ("pous", &["pou"]),
    ("pou", &["interface", "body", "documentation"]),
    ("body", &["ST"]),
    ("ST", &["xhtml"]),
    ("documentation", &["xhtml"]),
    ("returnType", &["BOOL", "INT", "DINT", "REAL", "LREAL", "derived"]),
    ("instances", &["configurations"]),
    ("configurations", &[]),
    ("xhtml", &[]),
];

fn source(id: &str) -> String {
    language(id).unwrap().write(&export("level", LOOPS[0], Float::Double).0)
}

#[test]
fn every_element_is_where_the_schema_has_it() {
    let text = source("plcopen");
    let document = Document::parse(&text).unwrap();
    let lists = ["localVars", "inputVars", "outputVars", "inOutVars"];
    for node in document.descendants().filter(Node::is_element) {
        let name = node.tag_name().name();
        assert_eq!(node.tag_name().namespace(), Some(if name == "xhtml" { XHTML } else { TC6 }), "{name}");
        let children: Vec<_> =
            node.children().filter(Node::is_element).map(|n| n.tag_name().name()).collect();
        if lists.contains(&name) {
            assert!(children.iter().all(|child| *child == "variable"), "{name}: {children:?}");
        } else if name == "interface" {
            let rest = children.iter().skip(usize::from(children.first() == Some(&"returnType")));
            assert!(rest.clone().all(|child| lists.contains(child)), "{children:?}");
        } else {
            let (_, allowed) = SCHEMA.iter().find(|(known, _)| *known == name).expect(name);
            let places: Vec<_> =
                children.iter().map(|child| allowed.iter().position(|a| a == child)).collect();
            assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{name}: {children:?}");
        }
        for (element, attributes) in [
            ("fileHeader", &["companyName", "productName", "productVersion", "creationDateTime"][..]),
            ("contentHeader", &["name"]),
            ("pou", &["name", "pouType"]),
            ("dataType", &["name"]),
            ("variable", &["name"]),
            ("simpleValue", &["value"]),
            ("dimension", &["lower", "upper"]),
        ] {
            if name == element {
                assert!(attributes.iter().all(|attribute| node.has_attribute(*attribute)), "{name}");
            }
        }
    }
}

/// The text of a program without comments and white space.
fn bare(text: &str) -> String {
    let mut rest = text;
    let mut bare = String::new();
    while let Some((before, comment)) = rest.split_once("(*") {
        bare += before;
        rest = comment.split_once("*)").unwrap().1;
    }
    (bare + rest).split_whitespace().collect()
}

fn child<'d>(node: Node<'d, 'd>, name: &str) -> Option<Node<'d, 'd>> {
    node.children().find(|child| child.has_tag_name((TC6, name)))
}

fn of(node: Node) -> String {
    let kind = node.first_element_child().unwrap();
    match kind.tag_name().name() {
        "derived" => kind.attribute("name").unwrap().to_owned(),
        "array" => {
            let dimension = child(kind, "dimension").unwrap();
            let (lower, upper) =
                (dimension.attribute("lower").unwrap(), dimension.attribute("upper").unwrap());
            format!("ARRAY[{lower}..{upper}] OF {}", of(child(kind, "baseType").unwrap()))
        }
        name => name.to_owned(),
    }
}

fn variables(list: Node) -> String {
    let mut text = String::new();
    for variable in list.children().filter(Node::is_element) {
        let initial = child(variable, "initialValue").and_then(|value| value.first_element_child());
        let initial =
            initial.map_or(String::new(), |value| format!(" := {}", value.attribute("value").unwrap()));
        let kind = of(child(variable, "type").unwrap());
        text += &format!("{} : {kind}{initial};\n", variable.attribute("name").unwrap());
    }
    text
}

#[test]
fn the_xml_is_the_program_of_the_structured_text() {
    let text = source("plcopen");
    let document = Document::parse(&text).unwrap();
    let mut program = String::new();
    for node in document.descendants().filter(Node::is_element) {
        let name = node.attribute("name").unwrap_or_default();
        if node.has_tag_name((TC6, "dataType")) {
            let fields = variables(child(node, "baseType").unwrap().first_element_child().unwrap());
            program += &format!("TYPE {name} : STRUCT {fields} END_STRUCT END_TYPE\n");
        }
        if !node.has_tag_name((TC6, "pou")) {
            continue;
        }
        let interface = child(node, "interface").unwrap();
        let keyword =
            if node.attribute("pouType") == Some("function") { "FUNCTION" } else { "FUNCTION_BLOCK" };
        let result =
            child(interface, "returnType").map_or(String::new(), |result| format!(" : {}", of(result)));
        program += &format!("{keyword} {name}{result}\n");
        for list in interface.children().filter(|list| list.tag_name().name().ends_with("Vars")) {
            program += match (list.tag_name().name(), list.has_attribute("constant")) {
                ("inputVars", _) => "VAR_INPUT ",
                ("outputVars", _) => "VAR_OUTPUT ",
                ("inOutVars", _) => "VAR_IN_OUT ",
                (_, true) => "VAR CONSTANT ",
                (_, false) => "VAR ",
            };
            program += &format!("{} END_VAR\n", variables(list));
        }
        let body =
            child(node, "body").unwrap().descendants().find(|n| n.has_tag_name((XHTML, "xhtml"))).unwrap();
        program += &format!("{} END_{keyword}\n", body.text().unwrap());
    }
    let (of_xml, of_text) = (bare(&program), bare(&source("st")));
    let differs = of_xml.bytes().zip(of_text.bytes()).position(|(one, other)| one != other);
    let from = differs.unwrap_or(of_xml.len().min(of_text.len())).saturating_sub(40);
    let end = |text: &str| text[from..].chars().take(80).collect::<String>();
    assert!(of_xml == of_text, "they part at\n{}\n{}", end(&of_xml), end(&of_text));
}
