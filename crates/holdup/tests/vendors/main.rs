//! Every registered vendor's block: in step with its folder, back as it went, and the law that its equation says.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

mod equations;
mod registry;
mod round_trip;

use holdup::deploy::conversion::{Scaling, Sheet, Span, Vendor, convert, vendors};
use holdup::model::Controller;
use holdup::model::notation::read_controller;

pub(crate) fn scaling(pv: f64, op: f64) -> Scaling {
    Scaling::new(Span::new(-1.0, pv - 1.0).unwrap(), Span::new(10.0, op + 10.0).unwrap())
}

/// Controllers of every structure. Times are whole tenths, so that blocks with steps take them.
fn designs() -> Vec<Controller> {
    let texts = [
        "Kc=2.5",
        "Kc=2.5,Ti=40",
        "Kc=2.5,Td=3",
        "Kc=2.5,Ti=40,Td=3",
        "Kc=2.5,Ti=40,Td=3,Tf=0.3",
        "Kc=2.5,Ti=40,Td=3,Tf=0.3,b=0.4,c=0",
        "Kc=2.5,Ti=40,b=0,c=0",
        "Kc=2.5,Ti=8,Td=3,N=2,c=0",
        "Kc=-2.5,Ti=40,Td=3,Tf=0.3,c=0",
        "Kc=-0.02,Ti=400,Td=60,N=0.5,b=0.25,c=0.5,Ko=-1,a1=2",
    ];
    texts.iter().map(|text| read_controller(text).unwrap()).collect()
}

/// Every sheet of every vendor for every design that it takes.
pub(crate) fn sheets() -> Vec<(&'static Vendor, Controller, Scaling, Sheet)> {
    let scaling = scaling(5.0, 80.0);
    let mut sheets = Vec::new();
    for &vendor in vendors() {
        let before = sheets.len();
        for design in designs() {
            if let Ok(sheet) = convert(vendor, &design, &scaling).sheet {
                sheets.push((vendor, design, scaling.clone(), sheet));
            }
        }
        assert!(sheets.len() - before >= 5, "{} takes too few designs", vendor.id);
    }
    sheets
}
