//! The file of the tables.

use super::super::curve::Curve;
use super::{Table, TableErrors};
use crate::tuning::optimise::{Filter, Objective, Structure};

/// Reads the file; a line for what is wrong with it.
pub(super) fn read(text: &str) -> Result<Vec<Table>, String> {
    let file: File = toml::from_str(text).map_err(|error| error.to_string())?;
    file.table.into_iter().map(Section::table).collect()
}

#[derive(serde::Deserialize)]
struct File {
    table: Vec<Section>,
}

#[derive(serde::Deserialize)]
struct Section {
    structure: String,
    filter_ratio: Option<f64>,
    objective: String,
    load_weight: Option<f64>,
    error: [f64; 3],
    knots: Vec<Vec<f64>>,
}

impl Section {
    fn table(self) -> Result<Table, String> {
        let unknown = |name: &str| format!("'{name}' is not known");
        let structure = Structure::named(&self.structure).ok_or_else(|| unknown(&self.structure))?;
        let objective = match (self.objective.as_str(), self.load_weight) {
            ("load_iae", None) => Objective::LoadIae,
            ("setpoint_iae", None) => Objective::SetpointIae,
            ("load_ise", None) => Objective::LoadIse,
            ("setpoint_ise", None) => Objective::SetpointIse,
            ("weighted_iae", Some(load)) => Objective::Weighted { load },
            _ => return Err(unknown(&self.objective)),
        };
        let settings = [true, structure.integrates(), structure.differentiates(), structure.observes()];
        let columns = 2 + settings.into_iter().filter(|there| *there).count();
        let whole = |row: &Vec<f64>| row.len() == columns && row.iter().all(|value| *value > 0.0);
        let rising = self.knots.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        if self.knots.len() < 2 || !self.knots.iter().all(whole) || !rising {
            return Err(format!(
                "{} {}: rows of {columns} positive numbers, the first rising",
                self.structure, self.objective
            ));
        }
        let column = |index: usize| self.knots.iter().map(|row| row[index]).collect::<Vec<f64>>();
        let knots = column(0);
        let curves = (1..columns).map(|index| Curve::new(&knots, &column(index))).collect();
        let [of_settings, value, sensitivity_peak] = self.error;
        let error = TableErrors { settings: of_settings, value, sensitivity_peak };
        let filter = self.filter_ratio.map_or(Filter::None, Filter::Held);
        Ok(Table { structure, filter, objective, error, knots, curves })
    }
}
