//! Shapes from the keys of a cell file.

use camino::Utf8Path;
use val3_collision::{Shape, ShapeError};
use val3_geometry::{IsometryMatrix3, Trsf, Vector3};

use crate::error::CellError;
use crate::file::{BoxKey, Corners, MeshUnit, ShapeEntry, ShapeKeys};
use crate::mesh::Mesh;
use crate::poses::{check_size, pose, triple};
use crate::surroundings::Surroundings;

/// Size in mm below which the unit of a mesh is probably metres.
const TINY: f64 = 5.0;

/// Size in mm above which the unit of a mesh is probably not metres.
const HUGE: f64 = 50_000.0;

/// Likely unit of a mesh whose size suggests a wrong unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum UnitDoubt {
    Metres,
    Millimetres,
    /// No unit yields a plausible size.
    Neither,
}

/// Returns the likely unit of a mesh if the assumed unit yields an implausible size. `unit` is the assumed unit's length,
/// and `extent` the resulting diagonal of the mesh, both in mm.
pub(crate) fn unit_doubt(unit: f64, extent: f64) -> Option<UnitDoubt> {
    let is_long = unit > 1.0;
    match extent {
        _ if extent < TINY && !is_long => Some(UnitDoubt::Metres),
        _ if extent > HUGE && is_long => Some(UnitDoubt::Millimetres),
        _ if extent > HUGE => Some(UnitDoubt::Neither),
        _ => None,
    }
}

/// One shape of a thing.
#[derive(Debug, Clone)]
pub struct Solid {
    /// The shape.
    pub shape: Shape,
    /// Pose of the shape in the thing's frame.
    pub pose: IsometryMatrix3<f64>,
    /// Form for pictures: as described, or the hull that represents a mesh.
    pub form: SolidForm,
}

/// Form of a shape, for pictures.
#[derive(Debug, Clone, PartialEq)]
pub enum SolidForm {
    /// Length, width and height of a box around the origin.
    Box([f64; 3]),
    /// A cylinder around the z axis.
    Cylinder {
        /// Radius.
        radius: f64,
        /// Length; the origin is at half of it.
        length: f64,
    },
    /// A capsule, or a sphere if both ends are the same point.
    Capsule {
        /// One end of the line.
        from: [f64; 3],
        /// The other end of the line.
        to: [f64; 3],
        /// Radius.
        radius: f64,
    },
    /// Triangles.
    Mesh(Mesh),
}

/// Context in which a shape is built.
pub(crate) struct SolidMaker<'s> {
    pub(crate) surroundings: &'s mut dyn Surroundings,
    /// Whether the arm carries the thing. A mesh is then replaced by its convex hull.
    pub(crate) is_carried: bool,
}

/// Shape keys in an entry with one or several shapes.
#[derive(Clone, Copy)]
pub(crate) struct ShapedEntry<'e> {
    pub(crate) name: &'e str,
    pub(crate) shapes: &'e [ShapeEntry],
    pub(crate) shape: &'e ShapeKeys,
}

/// Builds all shapes that an entry describes.
pub(crate) fn solids(entry: ShapedEntry<'_>, key: &str, mut maker: SolidMaker<'_>) -> Result<Vec<Solid>, CellError> {
    let ShapedEntry { name, shapes, shape } = entry;
    match solid(shape, &[], key, &mut maker)? {
        Some(_) if !shapes.is_empty() => {
            Err(CellError::new(key, format!("`{name}` has a shape and `shapes`"), "move the shape into `shapes`"))
        }
        Some(own) => Ok(vec![own]),
        None if shapes.is_empty() => Err(without_shape(key, &format!("`{name}`"))),
        None => {
            let several = shapes.iter().enumerate().map(|(index, several)| {
                let key = format!("{key}.shapes[{index}]");
                let solid = solid(&several.shape, &several.at, &key, &mut maker)?;
                solid.ok_or_else(|| without_shape(&key, "this shape"))
            });
            several.collect()
        }
    }
}

pub(crate) fn without_shape(key: &str, what: &str) -> CellError {
    let help = "add one of `box`, `cylinder`, `sphere`, `capsule`, `mesh`: `box = [200, 100, 50]`";
    CellError::new(key, format!("{what} has no shape"), help)
}

/// Builds the shape of these keys with a pose; `None` if the keys contain no shape.
pub(crate) fn solid(
    keys: &ShapeKeys,
    at: &[f64],
    key: &str,
    maker: &mut SolidMaker<'_>,
) -> Result<Option<Solid>, CellError> {
    let ShapeKeys { cuboid, cylinder, sphere, capsule, mesh, unit, hull } = keys;
    let place = pose(at, &format!("{key}.at"))?;
    let named = [
        ("box", cuboid.is_some()),
        ("cylinder", cylinder.is_some()),
        ("sphere", sphere.is_some()),
        ("capsule", capsule.is_some()),
        ("mesh", mesh.is_some()),
    ];
    let mut given = named.into_iter().filter(|(_, is_given)| *is_given).map(|(name, _)| name);
    let Some(name) = given.next() else { return Ok(None) };
    if let Some(second) = given.next() {
        let message = format!("`{name}` and `{second}` are two shapes");
        return Err(CellError::new(format!("{key}.{second}"), message, "list them: `shapes = [{ … }, { … }]`"));
    }
    let key = format!("{key}.{name}");
    if mesh.is_none() && (unit.is_some() || hull.is_some()) {
        return Err(CellError::new(key, "`unit` and `hull` belong to a mesh", "remove them"));
    }
    let (form, offset) = if let Some(cuboid) = cuboid {
        let (size, centre) = sides(cuboid, &key)?;
        (SolidForm::Box(size), centre)
    } else if let Some(cylinder) = cylinder {
        (SolidForm::Cylinder { radius: cylinder.radius, length: cylinder.length }, [0.0; 3])
    } else if let Some(sphere) = sphere {
        (SolidForm::Capsule { from: [0.0; 3], to: [0.0; 3], radius: sphere.radius }, [0.0; 3])
    } else if let Some(capsule) = capsule {
        (
            SolidForm::Capsule {
                from: triple(&capsule.from, &format!("{key}.from"))?,
                to: triple(&capsule.to, &format!("{key}.to"))?,
                radius: capsule.radius,
            },
            [0.0; 3],
        )
    } else if let Some(path) = mesh {
        (
            SolidForm::Mesh(mesh_in_mm(path, unit.unwrap_or_else(|| MeshUnit::of(path)), &key, maker.surroundings)?),
            [0.0; 3],
        )
    } else {
        return Ok(None);
    };
    form.numbers().into_iter().try_for_each(|number| check_size(number, &key))?;
    let shape = shape_of(&form, hull.unwrap_or(maker.is_carried))
        .map_err(|error| CellError::new(&key, format!("it is no shape: {error}"), ""))?;
    let form = drawn(form, &shape);
    let pose = place * Trsf::new(offset, [0.0; 3]).isometry();
    Ok(Some(Solid { shape, pose, form }))
}

/// Returns the form for pictures: a mesh is replaced by its hull if the hull is compared.
fn drawn(form: SolidForm, shape: &Shape) -> SolidForm {
    match (form, shape.hull_triangles()) {
        (SolidForm::Mesh(_), Some((points, triangles))) => SolidForm::Mesh(Mesh { points, triangles }),
        (form, _) => form,
    }
}

/// Returns the size and the centre of a box.
fn sides(cuboid: &BoxKey, key: &str) -> Result<([f64; 3], [f64; 3]), CellError> {
    match cuboid {
        BoxKey::Size(size) => Ok((triple(size, key)?, [0.0; 3])),
        BoxKey::Corners(Corners { min, max }) => {
            let corner = |corner: &[f64], name: &str| Ok(Vector3::from(triple(corner, &format!("{key}.{name}"))?));
            let (min, max) = (corner(min, "min")?, corner(max, "max")?);
            Ok(((max - min).into(), ((min + max) / 2.0).into()))
        }
    }
}

/// Help for a mesh that cannot be read.
const MESH: &str = "name an existing STL or GLB file of at most 32 MB, in the folder of this file or below";

/// Reads a mesh and converts it to mm. Rejects a size that suggests another unit.
fn mesh_in_mm(
    path: &Utf8Path,
    unit: MeshUnit,
    key: &str,
    surroundings: &mut dyn Surroundings,
) -> Result<Mesh, CellError> {
    let mesh = surroundings.mesh(path).map_err(|message| CellError::new(key, message, MESH))?;
    let mesh = mesh.scaled(unit.length());
    let extent = mesh.extent();
    let help = match unit_doubt(unit.length(), extent) {
        Some(UnitDoubt::Metres) => "is it in metres? add `unit = \"m\"`",
        Some(UnitDoubt::Millimetres) => "is it in mm? set `unit = \"mm\"`",
        Some(UnitDoubt::Neither) => "it would be larger than any cell: export it in mm",
        None => return Ok(mesh),
    };
    Err(CellError::new(key, format!("`{path}` is {extent:.2} mm long"), help))
}

impl Solid {
    /// Returns the shape, smaller by `depth` mm on each side, but with at least a tenth of all lengths.
    pub(crate) fn core(&self, depth: f64) -> Shape {
        shape_of(&self.form.core(depth), true).unwrap_or_else(|_| self.shape.clone())
    }
}

/// Smallest fraction of a length that remains in the core of a shape.
const CORE: f64 = 0.1;

impl SolidForm {
    /// Returns the lengths and coordinates in mm; none for a mesh.
    fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Box(size) => size.to_vec(),
            Self::Cylinder { radius, length } => vec![*radius, *length],
            Self::Capsule { from, to, radius } => [&from[..], &to[..], &[*radius]].concat(),
            Self::Mesh(_) => Vec::new(),
        }
    }

    fn core(&self, depth: f64) -> Self {
        let radius = |radius: f64| (radius - depth).max(CORE * radius);
        let length = |length: f64| (length - 2.0 * depth).max(CORE * length);
        match self {
            Self::Box(size) => Self::Box(size.map(length)),
            Self::Cylinder { radius: outer, length: height } => {
                Self::Cylinder { radius: radius(*outer), length: length(*height) }
            }
            Self::Capsule { from, to, radius: outer } => Self::Capsule { from: *from, to: *to, radius: radius(*outer) },
            Self::Mesh(mesh) => Self::Mesh(mesh.shrunk(depth, CORE)),
        }
    }
}

fn shape_of(form: &SolidForm, hull: bool) -> Result<Shape, ShapeError> {
    match form {
        SolidForm::Box(size) => Shape::cuboid(&Vector3::from(*size)),
        SolidForm::Cylinder { radius, length } => Shape::cylinder(*radius, *length),
        SolidForm::Capsule { from, to, radius } => Shape::capsule(Vector3::from(*from), Vector3::from(*to), *radius),
        SolidForm::Mesh(mesh) if hull => Shape::hull(&mesh.points),
        SolidForm::Mesh(mesh) => Shape::surface(&mesh.points, &mesh.triangles),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_is_drawn_as_its_hull_if_that_is_compared() {
        let corner = |number: u32| [number & 1, number >> 1 & 1, number >> 2].map(|side| f64::from(side) * 10.0).into();
        let mut points: Vec<Vector3<f64>> = (0..8).map(corner).collect();
        let inside = Vector3::new(5.0, 5.0, 5.0);
        points.push(inside);
        let mesh = Mesh { points, triangles: (0..7).map(|first| [first, first + 1, 8]).collect() };
        let surface = Shape::surface(&mesh.points, &mesh.triangles).unwrap();
        assert_eq!(drawn(SolidForm::Mesh(mesh.clone()), &surface), SolidForm::Mesh(mesh.clone()));
        let hull = Shape::hull(&mesh.points).unwrap();
        let SolidForm::Mesh(drawn) = drawn(SolidForm::Mesh(mesh), &hull) else { panic!("no mesh") };
        assert!(!drawn.points.contains(&inside) && drawn.points.len() == 8);
        assert_eq!(drawn.triangles.len(), 12);
    }
}
