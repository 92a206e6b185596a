//! Carriers of the things in a cell, by their names in the file.

use std::collections::{BTreeMap, BTreeSet};

use val3_geometry::{IsometryMatrix3, Trsf};

use crate::error::CellError;
use crate::file::ObjectEntry;
use crate::poses::pose;
use crate::surroundings::{ArmBase, DataKind, Surroundings};

/// Carrier of a thing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Carrier {
    /// `world`.
    World,
    /// A frame of the program, by name: `fPallet`, `fPallets[1]`, `library:fCell`.
    Frame(String),
    /// A link of the arm, from 1, in the frames of [`val3_kinematics::Arm::parts`].
    Link(usize),
    /// The flange.
    Flange,
    /// A tool of the program, by name.
    Tool(String),
}

impl Carrier {
    /// Whether the arm carries it.
    #[must_use]
    pub fn is_arm(&self) -> bool {
        matches!(self, Self::Link(_) | Self::Flange | Self::Tool(_))
    }
}

/// Meaning of a carrier's name in the file.
enum Named {
    Carrier(Carrier),
    Object(usize),
    /// A frame or tool that the application does not have.
    Missing,
}

/// A carrier, and a pose in its frame.
pub(crate) type Carried = (Carrier, IsometryMatrix3<f64>);

/// Returns the carrier of each object, and the pose of the object in it; `None` if the application lacks the carrier.
pub(crate) fn carriers(
    objects: &[ObjectEntry],
    arm: ArmBase,
    surroundings: &dyn Surroundings,
) -> Result<Vec<Option<Carried>>, CellError> {
    let names = names(objects)?;
    let named = objects.iter().enumerate().map(|(index, ObjectEntry { carrier, at, .. })| {
        let name = carrier.as_deref().unwrap_or("world");
        let (carrier, face) =
            CarrierNames { names: &names, arm, surroundings }.find(name, &format!("object[{index}].in"))?;
        Ok((carrier, face * pose(at, &format!("object[{index}].at"))?))
    });
    let named: Vec<(Named, IsometryMatrix3<f64>)> = named.collect::<Result<_, _>>()?;
    (0..named.len()).map(|index| resolve(index, &named, objects)).collect()
}

/// Returns the carrier of an object, followed through the objects between; `None` if the application lacks it.
fn resolve(
    index: usize,
    named: &[(Named, IsometryMatrix3<f64>)],
    objects: &[ObjectEntry],
) -> Result<Option<Carried>, CellError> {
    let mut pose = IsometryMatrix3::identity();
    let mut passed = BTreeSet::new();
    let mut next = index;
    while let Some((carrier, in_carrier)) = named.get(next).filter(|_| passed.insert(next)) {
        pose = in_carrier * pose;
        match carrier {
            Named::Carrier(carrier) => return Ok(Some((carrier.clone(), pose))),
            Named::Missing => return Ok(None),
            Named::Object(number) => next = *number,
        }
    }
    let name = objects.get(index).map(|object| object.name.as_str()).unwrap_or_default();
    let message = format!("`{name}` is carried by itself");
    Err(CellError::new(format!("object[{index}].in"), message, "one of these objects needs another `in`"))
}

/// Checks the names of objects, and returns their numbers.
fn names(objects: &[ObjectEntry]) -> Result<BTreeMap<&str, usize>, CellError> {
    let mut names = BTreeMap::new();
    for (index, ObjectEntry { name, .. }) in objects.iter().enumerate() {
        let key = format!("object[{index}].name");
        let fault = |message: String, help: &str| Err(CellError::new(&key, message, help));
        if name.is_empty() {
            return fault(format!("object {} has no name", index + 1), "add `name = \"…\"`: messages use it");
        }
        let is_letter = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == ' ';
        if !name.starts_with(|letter: char| letter.is_ascii_alphabetic() || letter == '_')
            || !name.chars().all(is_letter)
        {
            return fault(
                format!("`{name}` is no name"),
                "a name has letters, digits, `_` and blanks, and begins with a letter",
            );
        }
        if is_reserved(name) {
            return fault(format!("`{name}` is a part of the robot"), "choose another name");
        }
        if names.insert(name.as_str(), index).is_some() {
            return fault(format!("two objects have the name `{name}`"), "rename one of them");
        }
    }
    Ok(names)
}

fn is_reserved(name: &str) -> bool {
    matches!(name, "world" | "base" | "flange" | "arm") || link(name).is_some()
}

/// Number of a link by its name.
fn link(name: &str) -> Option<usize> {
    name.strip_prefix("link")?.parse().ok().filter(|_| name.len() == "link".len() + 1)
}

/// Names that `in` can have.
struct CarrierNames<'n> {
    names: &'n BTreeMap<&'n str, usize>,
    arm: ArmBase,
    surroundings: &'n dyn Surroundings,
}

impl CarrierNames<'_> {
    /// Returns the carrier with a name, and the pose of the named frame in it.
    fn find(&self, name: &str, key: &str) -> Result<(Named, IsometryMatrix3<f64>), CellError> {
        let here = IsometryMatrix3::identity();
        let fixed = |carrier| Ok((Named::Carrier(carrier), here));
        match (name, link(name)) {
            ("world", _) => fixed(Carrier::World),
            ("base", _) => {
                let face = Trsf::new([0.0, 0.0, -self.arm.height], [0.0; 3]).isometry();
                Ok((Named::Carrier(Carrier::World), face))
            }
            ("flange", _) => fixed(Carrier::Flange),
            (_, Some(link)) if (1..=self.arm.axes).contains(&link) => fixed(Carrier::Link(link)),
            (_, Some(_)) => {
                let help = format!("its links are `link1` to `link{}`", self.arm.axes);
                Err(CellError::new(key, format!("the arm has no `{name}`"), help))
            }
            _ => Ok((self.data_or_object(name, key)?, here)),
        }
    }

    fn data_or_object(&self, name: &str, key: &str) -> Result<Named, CellError> {
        let data = self.surroundings.carrier(name);
        match (self.names.get(name), data) {
            (Some(object), Err(_)) => Ok(Named::Object(*object)),
            (None, Ok(DataKind::Frame)) => Ok(Named::Carrier(Carrier::Frame(name.to_owned()))),
            (None, Ok(DataKind::Tool)) => Ok(Named::Carrier(Carrier::Tool(name.to_owned()))),
            (Some(_), Ok(kind)) => {
                let message = format!("`{name}` is an object of this file and {} of the application", kind.words());
                Err(CellError::new(key, message, "rename the object"))
            }
            (None, Err(None)) if self.surroundings.may_lack_data() => Ok(Named::Missing),
            (None, Err(similar)) => {
                let message = format!("there is no frame, tool or object `{name}`");
                let help = similar.map_or_else(
                    || {
                        "write `world`, `base`, `flange`, `link1`, or a name of the application or of this file"
                            .to_owned()
                    },
                    |similar| format!("did you mean `{similar}`?"),
                );
                Err(CellError::new(key, message, help))
            }
        }
    }
}
