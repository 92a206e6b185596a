//! Files with the shapes of the arm's links: the values of `[run] shapes`.

use std::borrow::Cow;
use std::fmt;

use camino::Utf8PathBuf;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error as _, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// File with the shape of the base or a link.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(extend("required" = ["file"]))]
struct LinkShapeTable {
    /// The STL or GLB file, relative to the folder of this file.
    #[schemars(with = "String")]
    file: Utf8PathBuf,
    /// The length unit of the file: by default `mm` for an STL file, `m` for a GLB file.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "LengthUnit")]
    unit: Option<LengthUnit>,
    /// The frame of the coordinates: `link` (default) is the frame that the link has in the chain of the arm. The axes of
    /// `zero` are parallel to `world` while all joints are 0.
    frame: LinkShapeFrame,
    /// The origin of the coordinates with `frame = "zero"`, in mm from the mounting face while all joints are 0;
    /// `[0, 0, 0]` by default.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "origin")]
    #[schemars(with = "Vec<f64>", length(equal = 3))]
    origin: Option<[f64; 3]>,
}

/// File with the shape of the base or a link: the path, or a table with the path and the coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkShapeFile {
    /// The file, relative to the folder of the settings file.
    pub file: Utf8PathBuf,
    /// Length unit of the file; `None` for the unit of its format.
    pub unit: Option<LengthUnit>,
    /// Origin of coordinates whose axes are parallel to `world` while all joints are 0, in mm from the mounting face;
    /// `None` for coordinates in the frame of the link.
    pub origin_at_zero: Option<[f64; 3]>,
}

/// Length unit of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum LengthUnit {
    /// Millimetres.
    Mm,
    /// Metres.
    M,
}

impl LengthUnit {
    /// Length of the unit in mm.
    pub const fn length(self) -> f64 {
        match self {
            Self::Mm => 1.0,
            Self::M => 1000.0,
        }
    }
}

/// Frame of the coordinates in a file.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
enum LinkShapeFrame {
    /// The frame of the link in the chain of the arm.
    #[default]
    Link,
    /// A frame whose axes are parallel to `world` while all joints are 0.
    Zero,
}

/// Reads the coordinates of an origin.
fn origin<'de, D: Deserializer<'de>>(input: D) -> Result<Option<[f64; 3]>, D::Error> {
    let origin = Vec::<f64>::deserialize(input)?;
    match <[f64; 3]>::try_from(origin) {
        Ok(origin) if origin.iter().all(|length| length.is_finite()) => Ok(Some(origin)),
        Ok(_) => Err(D::Error::custom("a coordinate of `origin` is not a number: write `[x, y, z]` in mm")),
        Err(other) => Err(D::Error::custom(format!(
            "`origin` has 3 numbers, `[x, y, z]` in mm, and this list has {}",
            other.len()
        ))),
    }
}

impl From<Utf8PathBuf> for LinkShapeFile {
    fn from(file: Utf8PathBuf) -> Self {
        Self { file, unit: None, origin_at_zero: None }
    }
}

impl<'de> Deserialize<'de> for LinkShapeFile {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        input.deserialize_any(LinkShapeVisitor)
    }
}

/// Reader of a path or a table, which keeps the messages about the keys of the table.
struct LinkShapeVisitor;

impl<'de> Visitor<'de> for LinkShapeVisitor {
    type Value = LinkShapeFile;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a file, or a table: {{ file = \"link1.stl\", unit = \"m\" }}")
    }

    fn visit_str<E: serde::de::Error>(self, file: &str) -> Result<LinkShapeFile, E> {
        Ok(LinkShapeFile::from(Utf8PathBuf::from(file)))
    }

    fn visit_map<A: MapAccess<'de>>(self, table: A) -> Result<LinkShapeFile, A::Error> {
        let LinkShapeTable { file, unit, frame, origin } = Deserialize::deserialize(MapAccessDeserializer::new(table))?;
        if file.as_str().is_empty() {
            return Err(A::Error::custom("this table has no `file`: write `{ file = \"link1.stl\", unit = \"m\" }`"));
        }
        let origin_at_zero = match (frame, origin) {
            (LinkShapeFrame::Zero, origin) => Some(origin.unwrap_or_default()),
            (LinkShapeFrame::Link, None) => None,
            (LinkShapeFrame::Link, Some(_)) => {
                return Err(A::Error::custom(
                    "`origin` needs `frame = \"zero\"`: a link has the origin of its own frame",
                ));
            }
        };
        Ok(LinkShapeFile { file, unit, origin_at_zero })
    }
}

impl Serialize for LinkShapeFile {
    fn serialize<S: Serializer>(&self, output: S) -> Result<S::Ok, S::Error> {
        let Self { file, unit, origin_at_zero } = self.clone();
        if unit.is_none() && origin_at_zero.is_none() {
            return file.serialize(output);
        }
        let frame = if origin_at_zero.is_some() { LinkShapeFrame::Zero } else { LinkShapeFrame::Link };
        LinkShapeTable { file, unit, frame, origin: origin_at_zero }.serialize(output)
    }
}

impl JsonSchema for LinkShapeFile {
    fn schema_name() -> Cow<'static, str> {
        "LinkShapeFile".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = LinkShapeTable::json_schema(generator);
        schema.insert("type".to_owned(), ["string", "object"].as_slice().into());
        schema
    }
}

#[cfg(test)]
mod tests {
    use camino::Utf8Path;
    use expect_test::{Expect, expect};

    use super::*;
    use crate::ConfigFile;

    fn read(value: &str) -> Result<LinkShapeFile, String> {
        let file = ConfigFile::parse(Utf8Path::new("val3.toml"), &format!("[run.shapes]\nbase = {value}\n"));
        file.map(|file| file.config.run.shapes["base"].clone()).map_err(|error| error.to_string())
    }

    #[track_caller]
    fn refused(value: &str, expected: Expect) {
        expected.assert_eq(&(read(value).unwrap_err() + "\n"));
    }

    #[test]
    fn a_shape_is_a_path_or_a_table() {
        let file = Utf8PathBuf::from("a.stl");
        let table =
            LinkShapeFile { file: file.clone(), unit: Some(LengthUnit::M), origin_at_zero: Some([0.0, 20.0, 375.0]) };
        assert_eq!(read("\"a.stl\""), Ok(file.clone().into()));
        assert_eq!(read("{ file = \"a.stl\" }"), Ok(file.clone().into()));
        assert_eq!(
            read("{ file = \"a.stl\", frame = \"zero\" }"),
            Ok(LinkShapeFile { unit: None, origin_at_zero: Some([0.0; 3]), ..table.clone() })
        );
        assert_eq!(
            read("{ file = \"a.stl\", unit = \"m\", frame = \"zero\", origin = [0, 20, 375] }").as_ref(),
            Ok(&table)
        );
        assert_eq!(serde_json::to_string(&LinkShapeFile::from(file)).unwrap(), "\"a.stl\"");
        assert_eq!(
            serde_json::to_string(&table).unwrap(),
            r#"{"file":"a.stl","unit":"m","frame":"zero","origin":[0.0,20.0,375.0]}"#
        );
    }

    #[test]
    fn wrong_coordinates_are_refused_at_their_place() {
        refused(
            "{ file = \"a.stl\", unit = \"inch\" }",
            expect![[r#"
            `run.shapes.base.unit` must be one of mm, m, not "inch"
             --> val3.toml:2
              |
            2 | base = { file = "a.stl", unit = "inch" }
              |                                 ^^^^^^
        "#]],
        );
        refused(
            "{ file = \"a.stl\", frame = \"base\" }",
            expect![[r#"
            `run.shapes.base.frame` must be one of link, zero, not "base"
             --> val3.toml:2
              |
            2 | base = { file = "a.stl", frame = "base" }
              |                                  ^^^^^^
        "#]],
        );
        refused(
            "{ file = \"a.stl\", units = \"m\" }",
            expect![[r#"
            there is no setting `run.shapes.base.units`
             --> val3.toml:2
              |
            2 | base = { file = "a.stl", units = "m" }
              |                          ^^^^^
              help: did you mean `unit`?
        "#]],
        );
        refused(
            "{ unit = \"m\" }",
            expect![[r#"
            this table has no `file`: write `{ file = "link1.stl", unit = "m" }`
             --> val3.toml:2
              |
            2 | base = { unit = "m" }
              |        ^^^^^^^^^^^^^^
        "#]],
        );
        refused(
            "{ file = \"a.stl\", frame = \"zero\", origin = [0, 0] }",
            expect![[r#"
            `origin` has 3 numbers, `[x, y, z]` in mm, and this list has 2
             --> val3.toml:2
              |
            2 | base = { file = "a.stl", frame = "zero", origin = [0, 0] }
              |                                                   ^^^^^^
        "#]],
        );
        refused(
            "{ file = \"a.stl\", origin = [0, 0, 0] }",
            expect![[r#"
            `origin` needs `frame = "zero"`: a link has the origin of its own frame
             --> val3.toml:2
              |
            2 | base = { file = "a.stl", origin = [0, 0, 0] }
              |        ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
        "#]],
        );
        refused(
            "3",
            expect![[r#"
            `run.shapes.base` must be a text in quotes or a table, and this is a whole number
             --> val3.toml:2
              |
            2 | base = 3
              |        ^
        "#]],
        );
    }
}
