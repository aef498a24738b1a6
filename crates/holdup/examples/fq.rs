use holdup::analysis::frequency::margins;
use holdup::model::*;
fn main() {
    let p = Process::integrating(1.0, Seconds(1.0)).unwrap();
    let c = Controller::proportional(0.7).unwrap();
    println!("{:#?}", margins(&ClosedLoop::new(&p, &c)));
}
