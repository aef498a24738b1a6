//! What is no record is refused in one line that says what is wrong and what to do.

use holdup::record::{ReadOptions, read, read_bytes};

fn refused(text: &str, options: &ReadOptions) -> String {
    let error = read_bytes(text.as_bytes(), options).err().map(|error| error.to_string());
    let error = error.unwrap_or_else(|| panic!("was read: {text}"));
    assert!(!error.contains(['\n', '\r']), "{error}");
    error
}

#[test]
fn each_fault_is_named() {
    let rows = "0,1,2\n1,1,2\n2,1,3\n";
    for (text, parts) in [
        (format!("time,a,b\n{rows}"), &["controlled variable", "--pv", "2 'a'", "3 'b'"][..]),
        (format!("time,pv,b\n{rows}"), &["manipulated variable", "--op", "3 'b'"]),
        (format!("x,pv,op\n{rows}"), &["time", "--time", "--sample-period", "1 'x'"]),
        (
            "time,L1.PV,L2.PV,op\n0,1,2,3\n1,2,3,4\n".to_owned(),
            &["several", "2 'L1.PV'", "3 'L2.PV'", "--pv"],
        ),
        ("time,pv,op\n0,1,2\n".to_owned(), &["1 usable rows", "at least 3"]),
        ("time,pv,op\n0,Bad,2\n1,Bad,2\n2,,3\n".to_owned(), &["line 2", "pv", "Bad", "3 rows"]),
        ("time,pv,op\n".to_owned(), &["no row", "time,pv,op"]),
        (
            "time,pv,op\n7,1,2\n3,1,2\n9,1,2\n1,1,3\n5,1,3\n2,1,3\n8,1,3\n".to_owned(),
            &["line ", "time", "goes back"],
        ),
        ("just some words\nand more of them\n".to_owned(), &["no row", "just some words"]),
        (String::new(), &["empty"]),
    ] {
        let error = refused(&text, &ReadOptions::default());
        for part in parts {
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}

#[test]
fn each_fault_of_the_options_is_named() {
    let text = "time,pv,op,sp\n0,1,2,3\n1,1,2,3\n2,1,3,3\n";
    let none = ReadOptions::default;
    for (options, parts) in [
        (
            ReadOptions { controlled_variable: Some("pw".to_owned()), ..none() },
            &["--pv", "pw", "did you mean 'pv'?", "3 'op'"][..],
        ),
        (ReadOptions { setpoint: Some("9".to_owned()), ..none() }, &["--sp", "9", "4 'sp'"]),
        (
            ReadOptions {
                controlled_variable: Some("op".to_owned()),
                manipulated_variable: Some("3".to_owned()),
                ..none()
            },
            &["op", "--pv", "--op"],
        ),
        (ReadOptions { controlled_span: Some((5.0, 5.0)), ..none() }, &["--pv-span", "5:5"]),
        (ReadOptions { sample_period: Some(-1.0), ..none() }, &["--sample-period", "-1"]),
        (ReadOptions { time_unit: Some(f64::NAN), ..none() }, &["--time-unit", "NaN"]),
    ] {
        let error = refused(text, &options);
        for part in parts {
            assert!(error.contains(part), "{error}");
        }
    }
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let folder = std::env::temp_dir().join(format!("holdup-record-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let error = |path: &std::path::Path| read(path, &ReadOptions::default()).unwrap_err().to_string();
    assert!(error(&folder).contains("folder"));
    assert!(error(&folder.join("absent.csv")).contains("no such file"));
    let great = folder.join("great.csv");
    // A sparse file: 2 GiB long, nothing on the disk.
    std::fs::File::create(&great).unwrap().set_len(2 << 30).unwrap();
    let refused = error(&great);
    assert!(refused.contains("2147483648") && refused.contains("1073741824"), "{refused}");
    std::fs::write(&great, b"PK\x03\x04").unwrap();
    assert!(error(&great).contains("Excel"));
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn an_output_that_never_moves_is_told() {
    let reading = read_bytes(b"time,pv,LV.op\n0,1,7\n1,2,7\n2,3,7\n", &ReadOptions::default()).unwrap();
    let error = reading.moves().unwrap_err().to_string();
    assert!(error.contains("LV.op is 7 in all 3 rows"), "{error}");
}
