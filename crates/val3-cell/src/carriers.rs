//! Carriers of the bodies in a cell, resolved from the names in the file.

use std::collections::{BTreeMap, BTreeSet};

use val3_geometry::{IsometryMatrix3, Trsf};

use crate::error::CellError;
use crate::file::ObjectEntry;
use crate::names::link_number;
use crate::poses::pose;
use crate::surroundings::{ArmBase, DataKind, Surroundings};

/// Carrier of a body: the frame relative to which its pose is constant.
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

/// Position of a body in the arm's chain: 0 for the base, the link number for a link, the number of axes + 1 for bodies
/// on the flange; `None` for stationary bodies.
pub(crate) type Chain = Option<usize>;

impl Carrier {
    /// Whether a body with this carrier moves with the arm.
    #[must_use]
    pub fn is_arm(&self) -> bool {
        matches!(self, Self::Link(_) | Self::Flange | Self::Tool(_))
    }

    /// Returns the position in the arm's chain for bodies with this carrier, on an arm with `axes` axes.
    pub(crate) fn chain(&self, axes: usize) -> Chain {
        match self {
            Self::World | Self::Frame(_) => None,
            Self::Link(link) => Some(*link),
            Self::Flange | Self::Tool(_) => Some(axes + 1),
        }
    }
}

/// Meaning of a carrier's name in the file.
enum Named {
    Carrier(Carrier),
    Object(usize),
    /// A frame or tool that the application does not have.
    Missing,
}

/// Carrier of an entry, and the entry's pose in the carrier's frame.
#[derive(Debug, Clone)]
pub(crate) struct Carried {
    pub(crate) carrier: Carrier,
    pub(crate) pose: IsometryMatrix3<f64>,
}

/// Keys `in` and `at` with the key of their entry, which error messages contain.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CarriedKeys<'k> {
    /// Name of the carrier.
    pub(crate) carrier: &'k str,
    pub(crate) at: &'k [f64],
    pub(crate) key: &'k str,
}

/// Resolved carriers of a cell's objects. Other entries can refer to objects as their carriers.
#[derive(Debug)]
pub(crate) struct Carriers<'o> {
    names: BTreeMap<&'o str, usize>,
    objects: Vec<Option<Carried>>,
    arm: ArmBase,
}

impl<'o> Carriers<'o> {
    pub(crate) fn build(
        objects: &'o [ObjectEntry],
        arm: ArmBase,
        surroundings: &dyn Surroundings,
    ) -> Result<Self, CellError> {
        let names = objects.iter().enumerate().map(|(index, object)| (object.name.as_str(), index)).collect();
        let named = objects.iter().enumerate().map(|(index, ObjectEntry { carrier, at, .. })| {
            let carrier = carrier.as_deref().unwrap_or("world");
            let key = format!("object[{index}]");
            CarrierNames { names: &names, arm, surroundings }.find(CarriedKeys { carrier, at, key: &key })
        });
        let named: Vec<(Named, IsometryMatrix3<f64>)> = named.collect::<Result<_, _>>()?;
        let resolved = (0..named.len()).map(|index| resolve(index, &named, objects));
        let objects = resolved.collect::<Result<_, _>>()?;
        Ok(Self { names, objects, arm })
    }

    /// Returns the carrier of the object with this index; `None` if the application does not have the carrier.
    pub(crate) fn of_object(&self, index: usize) -> Option<Carried> {
        self.objects.get(index).cloned().flatten()
    }

    /// Returns the carrier for the keys in any other entry; `None` if the application does not have the carrier.
    pub(crate) fn of(
        &self,
        keys: CarriedKeys<'_>,
        surroundings: &dyn Surroundings,
    ) -> Result<Option<Carried>, CellError> {
        let (named, pose) = CarrierNames { names: &self.names, arm: self.arm, surroundings }.find(keys)?;
        Ok(match named {
            Named::Carrier(carrier) => Some(Carried { carrier, pose }),
            Named::Missing => None,
            Named::Object(number) => {
                self.of_object(number).map(|object| Carried { pose: object.pose * pose, ..object })
            }
        })
    }
}

/// Follows the objects that carry the object with this index, up to a carrier that is no object; `None` if the
/// application does not have this carrier.
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
            Named::Carrier(carrier) => return Ok(Some(Carried { carrier: carrier.clone(), pose })),
            Named::Missing => return Ok(None),
            Named::Object(number) => next = *number,
        }
    }
    let name = objects.get(index).map(|object| object.name.as_str()).unwrap_or_default();
    let message = format!("`{name}` is carried by itself");
    Err(CellError::new(format!("object[{index}].in"), message, "one of these objects needs another `in`"))
}

/// Names that the key `in` can contain.
struct CarrierNames<'n> {
    names: &'n BTreeMap<&'n str, usize>,
    arm: ArmBase,
    surroundings: &'n dyn Surroundings,
}

impl CarrierNames<'_> {
    /// Returns the carrier or object that the keys name, and the entry's pose in its frame.
    fn find(
        &self,
        CarriedKeys { carrier, at, key }: CarriedKeys<'_>,
    ) -> Result<(Named, IsometryMatrix3<f64>), CellError> {
        let (named, face) = self.named(carrier, &format!("{key}.in"))?;
        Ok((named, face * pose(at, &format!("{key}.at"))?))
    }

    /// Returns the carrier or object with a name, and the pose of the named frame relative to it.
    fn named(&self, name: &str, key: &str) -> Result<(Named, IsometryMatrix3<f64>), CellError> {
        let here = IsometryMatrix3::identity();
        let fixed = |carrier| Ok((Named::Carrier(carrier), here));
        match (name, link_number(name)) {
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
