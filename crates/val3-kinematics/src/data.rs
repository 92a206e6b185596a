//! Arm file parser, with an error for each implausible value.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt;

use serde::Deserialize;
use toml::Spanned;
use val3_lines::LineIndex;

use crate::arm::{Arm, AxisLimits, Geometry, Payload};
use crate::scara::Scara;
use crate::shapes::LinkCapsule;
use crate::six_axis::SixAxis;

/// Nominal speed divided by maximum speed, if a file contains no nominal speed (model choice).
const NOMINAL_SPEED: f64 = 0.66;

/// Acceleration divided by nominal speed, in 1/s, if a file contains no acceleration (model choice).
const ACCELERATION: f64 = 5.0;

/// Largest accepted number.
const GREATEST: f64 = 1e6;

/// An error in an arm file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ArmError {
    /// Line, from 1.
    pub line: usize,
    /// Entry, for example `axes.min`; empty if the text is not TOML.
    pub key: String,
    /// Description of the error and its remedy.
    pub message: String,
}

impl fmt::Display for ArmError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, key, message } = self;
        if key.is_empty() { write!(f, "line {line}: {message}") } else { write!(f, "line {line}, {key}: {message}") }
    }
}

impl Error for ArmError {}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ArmDataFile {
    name: Spanned<String>,
    kind: ArmKind,
    #[serde(default)]
    sources: Vec<String>,
    #[serde(default)]
    model: Vec<Spanned<String>>,
    times: Option<Spanned<TimesOrigin>>,
    geometry: Spanned<Lengths>,
    axes: Spanned<ArmTableColumns>,
    payload: Option<Loads>,
    #[serde(default)]
    shapes: BTreeMap<Spanned<String>, Vec<Spanned<CapsuleEntry>>>,
}

/// Origin of nominal speeds, accelerations and decelerations.
#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
enum TimesOrigin {
    Model,
    Measured,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
enum ArmKind {
    SixAxis,
    Scara,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Lengths {
    a1: Option<Spanned<f64>>,
    b: Option<Spanned<f64>>,
    c2: Option<Spanned<f64>>,
    c3: Option<Spanned<f64>>,
    c4: Option<Spanned<f64>>,
    l1: Option<Spanned<f64>>,
    l2: Option<Spanned<f64>>,
    z0: Option<Spanned<f64>>,
    height: Option<Spanned<f64>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ArmTableColumns {
    min: Spanned<Vec<f64>>,
    max: Spanned<Vec<f64>>,
    nominal_speed: Option<Spanned<Vec<f64>>>,
    maximum_speed: Spanned<Vec<f64>>,
    acceleration: Option<Spanned<Vec<f64>>>,
    deceleration: Option<Spanned<Vec<f64>>>,
    maximum_effort: Option<Spanned<Vec<f64>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Loads {
    nominal: Option<Spanned<f64>>,
    maximum: Option<Spanned<f64>>,
}

/// A capsule around a link, in mm in the frame of the link.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CapsuleEntry {
    from: [f64; 3],
    to: [f64; 3],
    radius: f64,
}

/// Accepted sign of a length.
#[derive(Clone, Copy)]
enum Sign {
    Any,
    NotNegative,
    Positive,
}

/// Entries that a file may list under `model`. `geometry` stands for the lengths except `height`
/// and `z0`, and `limits` for `min` and `max`.
const MODEL_ENTRIES: &[&str] = &[
    "geometry",
    "height",
    "z0",
    "limits",
    "nominal_speed",
    "maximum_speed",
    "acceleration",
    "deceleration",
    "maximum_effort",
    "payload",
    "shapes",
];

/// Keys that must be measured if `times` is `"measured"`.
const TIME_ENTRIES: [&str; 3] = ["nominal_speed", "acceleration", "deceleration"];

pub(crate) fn parse(text: &str) -> Result<Arm, ArmError> {
    let file: ArmDataFile = toml::from_str(text).map_err(|error| ArmTableReader { text }.syntax(&error))?;
    ArmTableReader { text }.arm(&file)
}

struct ArmTableReader<'a> {
    text: &'a str,
}

impl ArmTableReader<'_> {
    fn arm(&self, file: &ArmDataFile) -> Result<Arm, ArmError> {
        if file.name.get_ref().trim().is_empty() {
            return Err(self.error(file.name.span().start, "name", "the name is empty, write one".to_owned()));
        }
        for entry in &file.model {
            if !MODEL_ENTRIES.contains(&entry.get_ref().as_str()) {
                let message = format!("`{}` is no entry, write one of {}", entry.get_ref(), MODEL_ENTRIES.join(", "));
                return Err(self.error(entry.span().start, "model", message));
            }
        }
        let (geometry, height) = self.geometry(file)?;
        Ok(Arm {
            name: file.name.get_ref().trim().to_owned(),
            geometry,
            axes: self.axes(file)?,
            payload: self.payload(file.payload.as_ref())?,
            height,
            sources: file.sources.clone(),
            model_choices: file.model.iter().map(|entry| entry.get_ref().clone()).collect(),
            has_measured_times: self.has_measured_times(file)?,
            calibration: None,
            shapes: self.shapes(file)?,
        })
    }

    /// Whether the file has measured times. Such a file must contain all of them, and must not list them as model
    /// choices.
    fn has_measured_times(&self, file: &ArmDataFile) -> Result<bool, ArmError> {
        let Some(times) = file.times.as_ref().filter(|times| *times.get_ref() == TimesOrigin::Measured) else {
            return Ok(false);
        };
        let columns = file.axes.get_ref();
        let present = [&columns.nominal_speed, &columns.acceleration, &columns.deceleration];
        for (entry, column) in TIME_ENTRIES.into_iter().zip(present) {
            let message = if column.is_none() {
                format!("measured times need `axes.{entry}`, add it or write `times = \"model\"`")
            } else if file.model.iter().any(|choice| choice.get_ref() == entry) {
                format!("`model` contains `{entry}`, remove it there or write `times = \"model\"`")
            } else {
                continue;
            };
            return Err(self.error(times.span().start, "times", message));
        }
        Ok(true)
    }

    fn geometry(&self, file: &ArmDataFile) -> Result<(Geometry, f64), ArmError> {
        let lengths = file.geometry.get_ref();
        let foreign = match file.kind {
            ArmKind::SixAxis => vec![("l1", &lengths.l1), ("l2", &lengths.l2), ("z0", &lengths.z0)],
            ArmKind::Scara => [("a1", &lengths.a1), ("b", &lengths.b), ("c2", &lengths.c2), ("c3", &lengths.c3)]
                .into_iter()
                .chain([("c4", &lengths.c4)])
                .collect(),
        };
        for (name, length) in foreign {
            if let Some(length) = length {
                let message = format!("{} has no such length, remove it", file.kind.described());
                return Err(self.error(length.span().start, &format!("geometry.{name}"), message));
            }
        }
        let read = |name, length: &Option<Spanned<f64>>, sign| self.length(file, name, length.as_ref(), sign);
        let height = match lengths.height {
            Some(_) => read("height", &lengths.height, Sign::NotNegative)?,
            None => 0.0,
        };
        let geometry = match file.kind {
            ArmKind::SixAxis => Geometry::SixAxis(SixAxis {
                a1: read("a1", &lengths.a1, Sign::NotNegative)?,
                b: read("b", &lengths.b, Sign::Any)?,
                c2: read("c2", &lengths.c2, Sign::Positive)?,
                c3: read("c3", &lengths.c3, Sign::Positive)?,
                c4: read("c4", &lengths.c4, Sign::NotNegative)?,
            }),
            ArmKind::Scara => Geometry::Scara(Scara {
                l1: read("l1", &lengths.l1, Sign::Positive)?,
                l2: read("l2", &lengths.l2, Sign::Positive)?,
                z0: read("z0", &lengths.z0, Sign::Any)?,
            }),
        };
        Ok((geometry, height))
    }

    /// Reads a length in mm that this kind of arm requires.
    fn length(
        &self,
        file: &ArmDataFile,
        name: &str,
        length: Option<&Spanned<f64>>,
        sign: Sign,
    ) -> Result<f64, ArmError> {
        let key = format!("geometry.{name}");
        let Some(length) = length else {
            let message = format!("{} needs this length, add it in mm", file.kind.described());
            return Err(self.error(file.geometry.span().start, &key, message));
        };
        self.number(*length.get_ref(), sign).map_err(|message| self.error(length.span().start, &key, message))
    }

    fn axes(&self, file: &ArmDataFile) -> Result<Vec<AxisLimits>, ArmError> {
        let columns = file.axes.get_ref();
        let count = file.kind.axes();
        let read = |name: &str, column: &Spanned<Vec<f64>>, sign| self.column(file.kind, name, column, sign);
        let optional = |name, column: &Option<_>| self.optional_column(file.kind, name, column.as_ref());
        let min = read("min", &columns.min, Sign::Any)?;
        let max = read("max", &columns.max, Sign::Any)?;
        let maximum_speed = read("maximum_speed", &columns.maximum_speed, Sign::Positive)?;
        let scaled = |column: &[f64], factor: f64| column.iter().map(|value| value * factor).collect::<Vec<_>>();
        let nominal_speed =
            optional("nominal_speed", &columns.nominal_speed)?.unwrap_or_else(|| scaled(&maximum_speed, NOMINAL_SPEED));
        let acceleration =
            optional("acceleration", &columns.acceleration)?.unwrap_or_else(|| scaled(&nominal_speed, ACCELERATION));
        let deceleration = optional("deceleration", &columns.deceleration)?.unwrap_or_else(|| acceleration.clone());
        let maximum_effort = optional("maximum_effort", &columns.maximum_effort)?;
        let at = |column: &[f64], index: usize| column.get(index).copied().unwrap_or_default();
        let mut axes = Vec::with_capacity(count);
        for index in 0..count {
            let axis = AxisLimits {
                min: at(&min, index),
                max: at(&max, index),
                nominal_speed: at(&nominal_speed, index),
                maximum_speed: at(&maximum_speed, index),
                acceleration: at(&acceleration, index),
                deceleration: at(&deceleration, index),
                maximum_effort: maximum_effort.as_ref().map(|column| at(column, index)),
            };
            self.check_axis(columns, index + 1, &axis)?;
            axes.push(axis);
        }
        Ok(axes)
    }

    /// Reads a column of positive numbers that a file may omit.
    fn optional_column(
        &self,
        kind: ArmKind,
        name: &str,
        column: Option<&Spanned<Vec<f64>>>,
    ) -> Result<Option<Vec<f64>>, ArmError> {
        column.map(|column| self.column(kind, name, column, Sign::Positive)).transpose()
    }

    fn check_axis(&self, columns: &ArmTableColumns, number: usize, axis: &AxisLimits) -> Result<(), ArmError> {
        let AxisLimits { min, max, nominal_speed, maximum_speed, .. } = *axis;
        if min >= max {
            let message = format!("axis {number} has min = {min} and max = {max}, min must be less than max");
            return Err(self.error(columns.min.span().start, "axes.min", message));
        }
        if nominal_speed > maximum_speed {
            let message = format!(
                "axis {number} has a nominal speed of {nominal_speed} above its maximum speed of {maximum_speed}, \
                 lower it"
            );
            let place = columns.nominal_speed.as_ref().unwrap_or(&columns.maximum_speed);
            return Err(self.error(place.span().start, "axes.nominal_speed", message));
        }
        Ok(())
    }

    fn column(&self, kind: ArmKind, name: &str, column: &Spanned<Vec<f64>>, sign: Sign) -> Result<Vec<f64>, ArmError> {
        let key = format!("axes.{name}");
        let values = column.get_ref();
        let error = |message| self.error(column.span().start, &key, message);
        if values.len() != kind.axes() {
            let (described, count) = (kind.described(), kind.axes());
            return Err(error(format!("{described} has {count} axes, but this has {} values", values.len())));
        }
        let checked = values.iter().enumerate().map(|(index, value)| {
            self.number(*value, sign).map_err(|message| error(format!("axis {}: {message}", index + 1)))
        });
        checked.collect()
    }

    fn payload(&self, loads: Option<&Loads>) -> Result<Payload, ArmError> {
        Ok(Payload {
            nominal: self.load("nominal", loads.and_then(|loads| loads.nominal.as_ref()))?,
            maximum: self.load("maximum", loads.and_then(|loads| loads.maximum.as_ref()))?,
        })
    }

    /// Reads a load, in kg.
    fn load(&self, name: &str, load: Option<&Spanned<f64>>) -> Result<Option<f64>, ArmError> {
        let Some(load) = load else { return Ok(None) };
        let number = self.number(*load.get_ref(), Sign::Positive);
        number.map(Some).map_err(|message| self.error(load.span().start, &format!("payload.{name}"), message))
    }

    /// Reads the shapes of the base and of all links. A file contains either no shapes or all of them.
    fn shapes(&self, file: &ArmDataFile) -> Result<Vec<Vec<LinkCapsule>>, ArmError> {
        if file.shapes.is_empty() {
            return Ok(Vec::new());
        }
        let names: Vec<String> = std::iter::once("base".to_owned())
            .chain((1..=file.kind.axes()).map(|axis| format!("link{axis}")))
            .collect();
        if let Some(stranger) = file.shapes.keys().find(|name| !names.contains(name.get_ref())) {
            let message = format!("{} has no such part, write one of {}", file.kind.described(), names.join(", "));
            return Err(self.error(stranger.span().start, &format!("shapes.{}", stranger.get_ref()), message));
        }
        names.iter().map(|name| self.part_shapes(file, name)).collect()
    }

    fn part_shapes(&self, file: &ArmDataFile, name: &str) -> Result<Vec<LinkCapsule>, ArmError> {
        let part = file.shapes.iter().find(|(part, _)| part.get_ref() == name);
        let Some((_, capsules)) = part.filter(|(_, capsules)| !capsules.is_empty()) else {
            let place = file.shapes.keys().next().map_or(0, |first| first.span().start);
            let message = "the other parts have shapes and this one has none, add a capsule".to_owned();
            return Err(self.error(place, &format!("shapes.{name}"), message));
        };
        capsules.iter().map(|capsule| self.capsule(name, capsule)).collect()
    }

    fn capsule(&self, name: &str, capsule: &Spanned<CapsuleEntry>) -> Result<LinkCapsule, ArmError> {
        let CapsuleEntry { from, to, radius } = capsule.get_ref();
        let mut numbers = from.iter().chain(to).map(|number| (*number, Sign::Any)).chain([(*radius, Sign::Positive)]);
        let checked = numbers.try_for_each(|(number, sign)| self.number(number, sign).map(|_| ()));
        checked.map_err(|message| self.error(capsule.span().start, &format!("shapes.{name}"), message))?;
        Ok(LinkCapsule { from: (*from).into(), to: (*to).into(), radius: *radius })
    }

    fn number(&self, value: f64, sign: Sign) -> Result<f64, String> {
        let fits = match sign {
            Sign::Any => true,
            Sign::NotNegative => value >= 0.0,
            Sign::Positive => value > 0.0,
        };
        if !value.is_finite() || value.abs() > GREATEST {
            return Err(format!("{value:?} is no usable number, write one between -1000000 and 1000000"));
        }
        match sign {
            _ if fits => Ok(value),
            Sign::Positive => Err(format!("{value} must be greater than 0")),
            _ => Err(format!("{value} must not be negative")),
        }
    }

    fn syntax(&self, error: &toml::de::Error) -> ArmError {
        let start = error.span().map_or(0, |span| span.start);
        self.error(start, "", error.message().replace("expected f64", "expected a number"))
    }

    fn error(&self, offset: usize, key: &str, message: String) -> ArmError {
        let line = LineIndex::new(self.text).line(offset) + 1;
        ArmError { line, key: key.to_owned(), message }
    }
}

impl ArmKind {
    const fn axes(self) -> usize {
        match self {
            Self::SixAxis => 6,
            Self::Scara => 4,
        }
    }

    const fn described(self) -> &'static str {
        match self {
            Self::SixAxis => "a six-axis arm",
            Self::Scara => "a SCARA arm",
        }
    }
}
