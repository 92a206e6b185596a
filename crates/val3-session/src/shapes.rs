//! Shapes of the arm's links, from the files named in `val3.toml`.

use std::sync::Arc;

use val3_cell::{LinkCoordinates, LinkError, LinkFile, LinkHull, Mesh, check_link_names, link_names};
use val3_config::{ConfigFile, LengthUnit};
use val3_files::FileClass;
use val3_kinematics::Arm;
use val3_machine::shapes::{LinkShape, ShapeFormat};

use crate::error::{SessionError, refused};

/// Shapes of the base and the links, in this order; `None` for a link without a file.
///
/// # Errors
/// If the arm has no link with a given key, or if a file cannot be used.
pub(crate) fn read(file: &ConfigFile, arm: &Arm) -> Result<Vec<Option<LinkShape>>, SessionError> {
    let shapes = &file.config.run.shapes;
    if shapes.is_empty() {
        return Ok(Vec::new());
    }
    check_link_names(shapes.keys(), arm.axes())
        .map_err(|error| refused(file, &error.key, error.message, &error.help))?;
    link_names(arm.axes()).enumerate().map(|(link, name)| shape(file, arm, link, &name)).collect()
}

/// Reads the shape of the base (0) or a link; `None` without a file.
fn shape(file: &ConfigFile, arm: &Arm, link: usize, name: &str) -> Result<Option<LinkShape>, SessionError> {
    let Some(of) = link_file(file, name) else { return Ok(None) };
    let (format, bytes) = content(file, name, &of)?;
    let LinkCoordinates { unit, pose } = of.coordinates(arm, link);
    Ok(Some(LinkShape { format, bytes, unit, pose }))
}

/// Convex hulls of the shapes, for distances.
///
/// # Errors
/// A file is no mesh, or its mesh is no mesh of the link.
pub(crate) fn hulls(
    file: &ConfigFile,
    shapes: &[Option<LinkShape>],
    arm: &Arm,
) -> Result<Vec<Option<LinkHull>>, SessionError> {
    let mut hulls = Vec::new();
    for (link, (name, shape)) in link_names(arm.axes()).zip(shapes).enumerate() {
        let shape = shape.as_ref().zip(link_file(file, &name));
        let hull = shape.map(|(shape, of)| hull(shape, &of, arm, link)).transpose();
        hulls.push(hull.map_err(|error| refused(file, &format!("run.shapes.{name}"), error.message, &error.help))?);
    }
    Ok(hulls)
}

/// Computes the convex hull of the shape that a file contains for the base (0) or a link.
fn hull(shape: &LinkShape, file: &LinkFile<'_>, arm: &Arm, link: usize) -> Result<LinkHull, LinkError> {
    let mesh = Mesh::read(&shape.bytes).map_err(|error| format!("cannot use `{}`: {error}", file.path))?;
    file.hull(mesh, arm, link)
}

/// Returns the file that the settings name for the base or a link.
fn link_file<'f>(file: &'f ConfigFile, name: &str) -> Option<LinkFile<'f>> {
    let shape = file.config.run.shapes.get(name)?;
    let unit = shape.unit.map(LengthUnit::length);
    Some(LinkFile { path: &shape.file, unit, origin_at_zero: shape.origin_at_zero })
}

/// Reads the file of the base or a link.
fn content(file: &ConfigFile, name: &str, of: &LinkFile<'_>) -> Result<(ShapeFormat, Arc<[u8]>), SessionError> {
    let named = of.path;
    let fault = |message: String, help: &str| refused(file, &format!("run.shapes.{name}"), message, help);
    let Some(format) = named.extension().and_then(ShapeFormat::of_extension) else {
        return Err(fault(format!("`{named}` is not a file of a known form"), "name a `.glb` or a `.stl` file"));
    };
    let path = file.folder().join(named);
    let help = "name an existing file of at most 32 MB, or remove the setting";
    let bytes = val3_files::read(&path, FileClass::Shape)
        .map_err(|reason| fault(format!("cannot read `{path}`: {reason}"), help))?;
    if !format.matches(&bytes) {
        let message = format!("`{path}` is no {} file", format.extension().to_uppercase());
        return Err(fault(message, "name a file that a CAD program has written in this form"));
    }
    Ok((format, bytes.into()))
}
