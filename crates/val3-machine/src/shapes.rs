//! Arm shapes for viewers, without effect on the motion.

use std::sync::Arc;

use val3_geometry::IsometryMatrix3;

/// The shape of a link.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkShape {
    /// File format.
    pub format: ShapeFormat,
    /// Content of the file.
    pub bytes: Arc<[u8]>,
    /// Length of the file's unit, in mm.
    pub unit: f64,
    /// Pose of the file's frame, with z up, in the frame of the link.
    pub pose: IsometryMatrix3<f64>,
}

/// File format of a shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShapeFormat {
    /// glTF in one binary file, usually in metres: y up.
    Glb,
    /// Triangles, usually in millimetres: z up.
    Stl,
}

impl ShapeFormat {
    /// File extension.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Glb => "glb",
            Self::Stl => "stl",
        }
    }

    /// Whether a file has this format, by the first bytes and the size.
    #[must_use]
    pub fn matches(self, bytes: &[u8]) -> bool {
        match self {
            Self::Glb => bytes.starts_with(b"glTF"),
            Self::Stl => bytes.trim_ascii_start().starts_with(b"solid") || is_binary_stl(bytes),
        }
    }

    /// Returns the format for a file extension, in any letter case.
    #[must_use]
    pub fn of_extension(extension: &str) -> Option<Self> {
        [Self::Glb, Self::Stl].into_iter().find(|format| format.extension().eq_ignore_ascii_case(extension))
    }
}

/// Whether the number of triangles after the head fits the size of the file.
fn is_binary_stl(bytes: &[u8]) -> bool {
    const HEAD: usize = 80;
    const TRIANGLE: usize = 50;
    let count = bytes.get(HEAD..HEAD + 4).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
    count.is_some_and(|count| (count as usize).checked_mul(TRIANGLE).is_some_and(|size| bytes.len() == HEAD + 4 + size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms_are_recognised_by_their_bytes() {
        assert!(ShapeFormat::Stl.matches(&binary(2, 2)) && ShapeFormat::Stl.matches(b"solid base\nendsolid base\n"));
        assert!(ShapeFormat::Glb.matches(b"glTF\x02"));
        for other in [&b"-----BEGIN OPENSSH PRIVATE KEY-----"[..], b"", b"gltf", &binary(3, 2)] {
            assert!(!ShapeFormat::Stl.matches(other) && !ShapeFormat::Glb.matches(other));
        }
    }

    /// A binary STL file that states this number of triangles.
    fn binary(count: u8, triangles: usize) -> Vec<u8> {
        let mut bytes = vec![0; 84 + 50 * triangles];
        bytes[80] = count;
        bytes
    }
}
