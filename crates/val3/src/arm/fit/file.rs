//! Arm file with measured times, created from an arm file without them.

use toml_edit::{Array, DocumentMut, Item, TableLike, Value};
use val3_kinematics::{Arm, AxisLimits};
use val3_session::ArmFile;

use crate::user_error::UserError;

use super::estimate::AxisTimes;
use super::words::{described, rounded};

/// Columns of the file with measured values.
const COLUMNS: [&str; 3] = ["nominal_speed", "acceleration", "deceleration"];

/// Source of the measured values.
const SOURCE: &str = "measured with the application of `val3 arm measure`";

/// Returns the text of the file: all values of `base`, with the times of the measured axes. The times of other axes are
/// copied from `base`.
pub(super) fn text(base: &ArmFile, measured: &[Option<&AxisTimes>]) -> Result<String, UserError> {
    let failed = |reason: String| UserError::new(format!("the arm file cannot be written: {reason}"));
    let (notes, values) = split_notes(&base.text);
    let mut document: DocumentMut = values.parse().map_err(|error: toml_edit::TomlError| failed(error.to_string()))?;
    let columns = document.get_mut("axes").and_then(Item::as_table_like_mut);
    let columns = columns.ok_or_else(|| failed("it has no table `axes`".to_owned()))?;
    set_columns(columns, base.arm.limits(), &axes(base.arm.limits(), measured));
    if measured.iter().all(Option::is_some) {
        document.insert("times", toml_edit::value("measured"));
        if let Some(choices) = document.get_mut("model").and_then(Item::as_array_mut) {
            choices.retain(|choice| !choice.as_str().is_some_and(|choice| COLUMNS.contains(&choice)));
        }
    }
    add_source(&mut document);
    let text = format!("{}{notes}{document}", head(&base.arm, measured));
    Arm::from_toml(&text).map_err(|error| failed(error.to_string()))?;
    Ok(text)
}

/// Returns the axes with their measured times.
fn axes(model: &[AxisLimits], measured: &[Option<&AxisTimes>]) -> Vec<AxisLimits> {
    model.iter().zip(measured).map(|(axis, times)| times.map_or(*axis, |times| with_times(axis, times))).collect()
}

/// Returns an axis with its measured times. A maximum speed below the nominal speed is raised to it.
fn with_times(axis: &AxisLimits, times: &AxisTimes) -> AxisLimits {
    let nominal_speed = rounded(times.speed.value);
    AxisLimits {
        nominal_speed,
        maximum_speed: axis.maximum_speed.max(nominal_speed),
        acceleration: rounded(times.acceleration.value),
        deceleration: rounded(times.deceleration.value),
        ..*axis
    }
}

fn set_columns(table: &mut dyn TableLike, model: &[AxisLimits], axes: &[AxisLimits]) {
    set_column(table, "nominal_speed", axes.iter().map(|axis| axis.nominal_speed));
    set_column(table, "acceleration", axes.iter().map(|axis| axis.acceleration));
    set_column(table, "deceleration", axes.iter().map(|axis| axis.deceleration));
    if model.iter().zip(axes).any(|(model, axis)| model.maximum_speed < axis.maximum_speed) {
        set_column(table, "maximum_speed", axes.iter().map(|axis| axis.maximum_speed));
    }
}

fn set_column(table: &mut dyn TableLike, name: &str, values: impl Iterator<Item = f64>) {
    table.insert(name, toml_edit::value(values.collect::<Array>()));
}

fn add_source(document: &mut DocumentMut) {
    let sources = document.entry("sources").or_insert_with(|| toml_edit::value(Array::new()));
    if let Some(sources) = sources.as_array_mut()
        && !sources.iter().any(|source| source.as_str() == Some(SOURCE))
    {
        let mut source = Value::from(SOURCE);
        // Placed on its own line if each source has its own line.
        if let Some(last) = sources.iter().last() {
            *source.decor_mut() = last.decor().clone();
        }
        sources.push_formatted(source);
    }
}

/// Splits a file into the comments at its beginning, formatted as notes for the new file, and the remaining text.
fn split_notes(text: &str) -> (String, &str) {
    let length = text.split_inclusive('\n').take_while(|line| line.starts_with('#')).map(str::len).sum();
    let (comments, values) = text.split_at(length);
    let notes = match comments.split_once(NOTES) {
        Some((_, notes)) => notes.to_owned(),
        // An earlier measurement's comments that contain no notes.
        None if comments.starts_with(HEAD) => String::new(),
        None => comments.lines().map(|line| format!("#   {}\n", line.trim_start_matches(['#', ' ']))).collect(),
    };
    let notes = if notes.is_empty() { notes } else { format!("{NOTES}{notes}") };
    (notes, values)
}

/// First words of the comment with the results.
const HEAD: &str = "# Times of a ";

/// Line above the comments that the file had before the measurement.
const NOTES: &str = "# Comments before the measurement:\n";

/// Comment with the results.
fn head(arm: &Arm, measured: &[Option<&AxisTimes>]) -> String {
    let mut head = format!("{HEAD}{}, {SOURCE}, with their standard uncertainties.\n", arm.name());
    for (index, times) in measured.iter().enumerate() {
        let values = times.map_or_else(|| "not measured".to_owned(), |times| described(arm.unit(index), times));
        head += &format!("#   axis {}: {values}\n", index + 1);
    }
    head
}

#[cfg(test)]
mod tests {
    use super::super::estimate::Estimate;
    use super::*;

    fn times(speed: f64) -> AxisTimes {
        let estimate = |value| Estimate { value, uncertainty: value / 1000.0 };
        AxisTimes {
            speed: estimate(speed),
            acceleration: estimate(1000.0),
            deceleration: estimate(900.123_456),
            delay: 0.002,
            residual: 0.001,
            moves: 39,
            rejected: 0,
        }
    }

    /// The file also has a maximum speed below the measured speed.
    #[test]
    fn a_file_without_optional_parts_gets_them() {
        let text = "name = \"mine\"\nkind = \"scara\"\ngeometry = { l1 = 300, l2 = 200, z0 = 0 }\n\
                    [axes] # mine\nmin = [-1, -1, 0, -1]\nmax = [1, 1, 1, 1]\nmaximum_speed = [100, 200, 300, 400]\n";
        let base = ArmFile { arm: Arm::from_toml(text).unwrap(), text: text.to_owned() };
        let measured = [50.0, 150.0, 250.0, 450.0].map(times);
        let measured: Vec<_> = measured.iter().map(Some).collect();
        let written = super::text(&base, &measured).unwrap();
        let (_, values) = written.split_once("name =").unwrap();
        expect_test::expect![[r#"
             "mine"
            kind = "scara"
            geometry = { l1 = 300, l2 = 200, z0 = 0 }
            times = "measured"
            sources = ["measured with the application of `val3 arm measure`"]
            [axes] # mine
            min = [-1, -1, 0, -1]
            max = [1, 1, 1, 1]
            maximum_speed = [100.0, 200.0, 300.0, 450.0]
            nominal_speed = [50.0, 150.0, 250.0, 450.0]
            acceleration = [1000.0, 1000.0, 1000.0, 1000.0]
            deceleration = [900.12, 900.12, 900.12, 900.12]
        "#]]
        .assert_eq(values);
        assert!(Arm::from_toml(&written).unwrap().has_measured_times());
    }
}
