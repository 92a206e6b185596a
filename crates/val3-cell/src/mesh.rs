//! Mesh reader for STL files (text or binary) and GLB files.

mod glb;

use std::collections::BTreeMap;
use std::fmt;

use val3_geometry::{IsometryMatrix3, Vector3};

/// Maximum number of triangles.
const MOST_TRIANGLES: usize = 200_000;

/// Bytes before the triangle count of a binary file.
const HEAD: usize = 80;

/// Size of a triangle in a binary file, in bytes: normal, three corners, attribute.
const TRIANGLE: usize = 50;

/// A surface that consists of triangles.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Corners without duplicates.
    pub points: Vec<Vector3<f64>>,
    /// Triangles, each as three indexes in [`Self::points`].
    pub triangles: Vec<[u32; 3]>,
}

/// Reason why a file is no mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeshError {
    /// The file is neither a text nor a binary STL file.
    Form,
    /// The GLB file cannot be used, for this reason.
    Glb(&'static str),
    /// The text form ends within a triangle, or has a corner that is not three numbers, at this line (from 1).
    Line(usize),
    /// The file contains no triangle.
    Empty,
    /// The file has this number of triangles, which exceeds the maximum.
    TooMany(usize),
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Form => write!(f, "it is not an STL file, or it is cut off"),
            Self::Glb(reason) => write!(f, "it cannot be used as a GLB file: {reason}"),
            Self::Line(line) => write!(f, "its line {line} is not a corner of a triangle: `vertex x y z`"),
            Self::Empty => write!(f, "it has no triangle"),
            Self::TooMany(count) => write!(f, "it has {count} triangles, and at most {MOST_TRIANGLES} are accepted"),
        }
    }
}

impl std::error::Error for MeshError {}

impl Mesh {
    /// Returns the mesh, smaller by `depth` mm on each side of the bounding box, but with at least the fraction `least`
    /// of all extents.
    pub(crate) fn shrunk(&self, depth: f64, least: f64) -> Self {
        let mut points = self.points.iter();
        let first = points.next().copied().unwrap_or_default();
        let (min, max) = points.fold((first, first), |(min, max), point| (min.inf(point), max.sup(point)));
        let factor = (max - min).map(|extent| ((extent - 2.0 * depth) / extent).max(least));
        let centre = (min + max) / 2.0;
        let points = self.points.iter().map(|point| centre + (point - centre).component_mul(&factor));
        Self { points: points.collect(), triangles: self.triangles.clone() }
    }

    /// Reads an STL file in its own unit, or a GLB file in metres with z up.
    ///
    /// # Errors
    ///
    /// The bytes are no mesh, or contain too many triangles.
    pub fn read(bytes: &[u8]) -> Result<Self, MeshError> {
        if bytes.starts_with(glb::MAGIC) {
            return glb::read(bytes).and_then(Self::checked);
        }
        let corners = match binary(bytes) {
            Some(corners) => corners?,
            None => text(bytes)?,
        };
        let mut unique = UniquePoints::default();
        let triangles = corners.as_chunks::<3>().0.iter();
        let triangles = triangles.map(|corners| corners.map(|corner| unique.index(corner))).collect();
        Self { points: unique.points, triangles }.checked()
    }

    /// Rejects a mesh without triangles.
    fn checked(self) -> Result<Self, MeshError> {
        if self.triangles.is_empty() { Err(MeshError::Empty) } else { Ok(self) }
    }

    /// Returns the mesh with all coordinates multiplied by a factor.
    pub(crate) fn scaled(mut self, factor: f64) -> Self {
        self.points.iter_mut().for_each(|point| *point *= factor);
        self
    }

    /// Returns the mesh in the frame relative to which the mesh's frame has this pose.
    pub(crate) fn placed(mut self, pose: &IsometryMatrix3<f64>) -> Self {
        self.points.iter_mut().for_each(|point| *point = pose.rotation * *point + pose.translation.vector);
        self
    }

    /// Returns the length of the bounding box diagonal.
    pub(crate) fn extent(&self) -> f64 {
        let Some(start) = self.points.first() else { return 0.0 };
        let (min, max) =
            self.points.iter().fold((*start, *start), |(min, max), point| (min.inf(point), max.sup(point)));
        (max - min).norm()
    }
}

/// Points without duplicates, in the order of their first occurrences.
#[derive(Default)]
struct UniquePoints {
    points: Vec<Vector3<f64>>,
    /// Index of each point, by the bits of its coordinates.
    indexes: BTreeMap<[u64; 3], u32>,
}

impl UniquePoints {
    /// Returns the index of a point. A new point is added.
    fn index(&mut self, point: Vector3<f64>) -> u32 {
        *self.indexes.entry([point.x, point.y, point.z].map(f64::to_bits)).or_insert_with(|| {
            self.points.push(point);
            u32::try_from(self.points.len() - 1).unwrap_or(u32::MAX)
        })
    }
}

/// Returns the corners of a binary file, three for each triangle; `None` if the file size does not match the triangle
/// count.
fn binary(bytes: &[u8]) -> Option<Result<Vec<Vector3<f64>>, MeshError>> {
    let (count, body) = bytes.get(HEAD..)?.split_first_chunk::<4>()?;
    let count = usize::try_from(u32::from_le_bytes(*count)).ok()?;
    if count.checked_mul(TRIANGLE)? != body.len() {
        return None;
    }
    if count > MOST_TRIANGLES {
        return Some(Err(MeshError::TooMany(count)));
    }
    let number = |bytes: &[u8; 4]| f64::from(f32::from_le_bytes(*bytes));
    let corners = body.as_chunks::<TRIANGLE>().0.iter().flat_map(|triangle| {
        let numbers: Vec<f64> = triangle.as_chunks::<4>().0.iter().skip(3).map(number).collect();
        let corners = numbers.as_chunks::<3>().0;
        corners.iter().map(|corner| Vector3::from(*corner)).collect::<Vec<_>>()
    });
    Some(Ok(corners.collect()))
}

/// Returns the corners of a file in text form.
fn text(bytes: &[u8]) -> Result<Vec<Vector3<f64>>, MeshError> {
    let text = str::from_utf8(bytes).map_err(|_| MeshError::Form)?;
    if !text.trim_start().starts_with("solid") {
        return Err(MeshError::Form);
    }
    let mut corners = Vec::new();
    let mut last = 0;
    for (index, line) in text.lines().enumerate() {
        let Some(numbers) = line.trim().strip_prefix("vertex") else { continue };
        last = index + 1;
        let numbers: Result<Vec<f64>, _> = numbers.split_whitespace().map(str::parse).collect();
        let numbers = numbers.map_err(|_| MeshError::Line(last))?;
        let corner = <[f64; 3]>::try_from(numbers).map_err(|_| MeshError::Line(last))?;
        corners.push(Vector3::from(corner));
    }
    match corners.len() {
        count if count % 3 != 0 => Err(MeshError::Line(last)),
        count if count / 3 > MOST_TRIANGLES => Err(MeshError::TooMany(count / 3)),
        _ if text.trim_end().rsplit('\n').next().is_some_and(|end| end.trim_start().starts_with("endsolid")) => {
            Ok(corners)
        }
        _ => Err(MeshError::Form),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "solid fin\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 10 0 0\nvertex 0 5 0\n\
                        endloop\nendfacet\nendsolid fin\n";

    /// Binary file whose triangles have these corners.
    fn binary_file(corners: &[[f32; 3]]) -> Vec<u8> {
        let mut bytes = vec![b' '; HEAD];
        bytes.extend(u32::try_from(corners.len() / 3).unwrap().to_le_bytes());
        for triangle in corners.chunks(3) {
            bytes.extend([0; 12]);
            bytes.extend(triangle.iter().flatten().flat_map(|number| number.to_le_bytes()));
            bytes.extend([0; 2]);
        }
        bytes
    }

    #[test]
    fn both_forms_of_a_file_are_the_same_mesh() {
        let of_text = Mesh::read(TEXT.as_bytes()).unwrap();
        let of_bytes = Mesh::read(&binary_file(&[[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 5.0, 0.0]])).unwrap();
        assert_eq!(of_text, of_bytes);
        assert_eq!((of_text.points.len(), of_text.triangles), (3, vec![[0, 1, 2]]));
    }

    #[test]
    fn corners_are_shared() {
        let square =
            [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let mesh = Mesh::read(&binary_file(&square)).unwrap();
        assert_eq!((mesh.points.len(), mesh.triangles), (4, vec![[0, 1, 2], [1, 3, 2]]));
    }

    #[test]
    fn damaged_files_are_refused() {
        let error = |bytes: &[u8]| Mesh::read(bytes).unwrap_err();
        let whole = binary_file(&[[0.0; 3]; 3]);
        assert_eq!(error(whole.get(..100).unwrap()), MeshError::Form);
        assert_eq!(error(b""), MeshError::Form);
        assert_eq!(error(&binary_file(&[])), MeshError::Empty);
        assert_eq!(error(b"solid a\nendsolid a\n"), MeshError::Empty);
        assert_eq!(error(TEXT.replace("10 0 0", "10 0").as_bytes()), MeshError::Line(5));
        assert_eq!(error(TEXT.replace("10 0 0", "10 0 l 0").as_bytes()), MeshError::Line(5));
        assert_eq!(error(TEXT.replace("vertex 0 5 0\n", "").as_bytes()), MeshError::Line(5));
        let cut = TEXT.find("endloop").unwrap();
        assert_eq!(error(TEXT.get(..cut).unwrap().as_bytes()), MeshError::Form);
    }
}
