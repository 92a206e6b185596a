//! Expectations about motion, as written in files.

use std::fmt;

use serde::de::{Error, MapAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer, de};

use crate::distance::Tolerances;

/// Default tolerances.
const TOLERANCES: Tolerances = Tolerances { mm: 0.5, degrees: 0.5, time: 5.0 };

/// Recorded trace for a comparison: `trace = "golden/cycle.csv"`, or a table with tolerances.
#[derive(Debug, Clone, PartialEq)]
pub struct TraceFile {
    /// Path of the file.
    pub file: String,
    /// Maximum differences.
    pub tolerances: Tolerances,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TraceTable {
    file: String,
    mm: Option<Positive>,
    degrees: Option<Positive>,
    time: Option<Positive>,
}

impl From<TraceTable> for TraceFile {
    fn from(TraceTable { file, mm, degrees, time }: TraceTable) -> Self {
        let or = |value: Option<Positive>, default| value.map_or(default, |Positive(value)| value);
        let tolerances = Tolerances {
            mm: or(mm, TOLERANCES.mm),
            degrees: or(degrees, TOLERANCES.degrees),
            time: or(time, TOLERANCES.time),
        };
        Self { file, tolerances }
    }
}

impl<'de> Deserialize<'de> for TraceFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(FileOrTable)
    }
}

struct FileOrTable;

impl<'de> Visitor<'de> for FileOrTable {
    type Value = TraceFile;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the path of a trace, or a table such as { file = \"golden/cycle.csv\", mm = 0.5 }")
    }

    fn visit_str<E: Error>(self, file: &str) -> Result<TraceFile, E> {
        Ok(TraceFile { file: file.to_owned(), tolerances: TOLERANCES })
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<TraceFile, A::Error> {
        TraceTable::deserialize(de::value::MapAccessDeserializer::new(map)).map(TraceFile::from)
    }
}

/// Speed limit, in a table `[[expect.speed]]`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Speed {
    /// Maximum speed in mm/s.
    pub below: Positive,
    /// Box in which the limit applies; `None` for everywhere.
    #[serde(rename = "box")]
    pub zone: Option<ZoneSetting>,
}

/// Box that the tool centre point must not leave, in a table `[[expect.inside]]`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Inside {
    /// Box.
    #[serde(rename = "box")]
    pub zone: ZoneSetting,
}

/// Box that the tool centre point must avoid, in a table `[[expect.clear]]`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Clear {
    /// Box.
    #[serde(rename = "box")]
    pub zone: ZoneSetting,
    /// Minimum distance in mm.
    pub distance: Positive,
}

/// A box between two corners, in mm.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(try_from = "Corners")]
pub struct ZoneSetting {
    /// Corner with the smallest coordinates.
    pub min: [f64; 3],
    /// Corner with the largest coordinates.
    pub max: [f64; 3],
    /// Frame of the coordinates, a variable of the application; `None` for `world`.
    pub frame: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Corners {
    min: [f64; 3],
    max: [f64; 3],
    frame: Option<String>,
}

impl TryFrom<Corners> for ZoneSetting {
    type Error = String;

    fn try_from(Corners { min, max, frame }: Corners) -> Result<Self, String> {
        if let Some(axis) = (0..3).find(|axis| !is_range(min.get(*axis), max.get(*axis))) {
            let name = ["x", "y", "z"].get(axis).copied().unwrap_or_default();
            return Err(format!("`min` must be below `max` in {name}"));
        }
        Ok(Self { min, max, frame })
    }
}

fn is_range(min: Option<&f64>, max: Option<&f64>) -> bool {
    min.zip(max).is_some_and(|(min, max)| min < max)
}

/// A finite number above 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Positive(pub f64);

impl<'de> Deserialize<'de> for Positive {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let number = f64::deserialize(deserializer)?;
        let is_positive = number > 0.0 && number.is_finite();
        if is_positive {
            Ok(Self(number))
        } else {
            Err(D::Error::invalid_value(Unexpected::Float(number), &"a number above 0"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, Deserialize)]
    struct Expect {
        trace: Option<TraceFile>,
        #[serde(default)]
        speed: Vec<Speed>,
        #[serde(default)]
        inside: Vec<Inside>,
        #[serde(default)]
        clear: Vec<Clear>,
    }

    fn read(text: &str) -> Expect {
        toml::from_str(text).unwrap()
    }

    #[track_caller]
    fn refused(text: &str, message: &str) {
        let error = toml::from_str::<Expect>(text).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }

    #[test]
    fn a_trace_is_a_path_or_a_table() {
        let trace = |text| read(text).trace.unwrap();
        let short = trace("trace = \"golden/cycle.csv\"");
        assert_eq!(short, TraceFile { file: "golden/cycle.csv".to_owned(), tolerances: TOLERANCES });
        assert_eq!(short.tolerances, Tolerances { mm: 0.5, degrees: 0.5, time: 5.0 });
        assert_eq!(trace("trace = { file = \"golden/cycle.csv\" }"), short);
        let long = trace("trace = { file = \"a.csv\", mm = 1, degrees = 0.2, time = 10.5 }");
        assert_eq!(long.tolerances, Tolerances { mm: 1.0, degrees: 0.2, time: 10.5 });
    }

    #[test]
    fn limits_have_boxes() {
        let expect = read(
            "[[speed]]\nbelow = 250\n[[speed]]\nbelow = 99.5\nbox = { min = [0, -1, 2], max = [1, 0, 2.5] }\n\
             [[inside]]\nbox = { min = [0, 0, 0], max = [1, 1, 1], frame = \"fPallet\" }\n\
             [[clear]]\nbox = { min = [0, 0, 0], max = [1, 1, 1] }\ndistance = 50\n",
        );
        assert_eq!((expect.speed[0].below, expect.speed[0].zone.is_none()), (Positive(250.0), true));
        let zone = expect.speed[1].zone.as_ref().unwrap();
        assert_eq!((zone.min, zone.max, &zone.frame), ([0.0, -1.0, 2.0], [1.0, 0.0, 2.5], &None));
        assert_eq!(expect.inside[0].zone.frame.as_deref(), Some("fPallet"));
        assert_eq!(expect.clear[0].distance, Positive(50.0));
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        refused("trace = 5", "the path of a trace, or a table such as { file = \"golden/cycle.csv\", mm = 0.5 }");
        refused("trace = { mm = 1 }", "missing field `file`");
        refused(
            "trace = { file = \"a\", degree = 1 }",
            "unknown field `degree`, expected one of `file`, `mm`, `degrees`, `time`",
        );
        refused("trace = { file = \"a\", mm = 0 }", "expected a number above 0");
        refused("trace = { file = \"a\", mm = inf }", "expected a number above 0");
        refused("trace = { file = \"a\", time = -5 }", "expected a number above 0");
        refused("[[speed]]\nbox = { min = [0, 0, 0], max = [1, 1, 1] }", "missing field `below`");
        refused("[[inside]]\nbox = { min = [0, 0], max = [1, 1, 1] }", "expected an array of length 3");
        refused("[[inside]]\nbox = { min = [0, 1, 0], max = [1, 1, 1] }", "`min` must be below `max` in y");
        refused("[[inside]]\nbox = { min = [0, 0, 2], max = [1, 1, 1] }", "`min` must be below `max` in z");
        refused("[[inside]]\nbox = { min = [0, 0, nan], max = [1, 1, 1] }", "`min` must be below `max` in z");
        refused("[[clear]]\nbox = { min = [0, 0, 0], max = [1, 1, 1] }", "missing field `distance`");
    }
}
