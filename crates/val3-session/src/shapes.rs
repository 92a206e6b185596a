//! Shapes of the arm's links, from the files named in `val3.toml`.

use camino::Utf8PathBuf;
use val3_cell::{LinkHull, Mesh, link_names};
use val3_config::ConfigFile;
use val3_files::FileClass;
use val3_machine::shapes::{LinkShape, ShapeFormat};

use crate::error::{SessionError, refused};

/// Shapes of the base and the links, in this order; `None` for a link without a file.
///
/// # Errors
/// If an arm with this number of axes has no link with a given key, or if a file cannot be used.
pub(crate) fn read(file: &ConfigFile, axes: usize) -> Result<Vec<Option<LinkShape>>, SessionError> {
    let names: Vec<String> = link_names(axes).collect();
    let shapes = &file.config.run.shapes;
    if shapes.is_empty() {
        return Ok(Vec::new());
    }
    if let Some(name) = shapes.keys().find(|name| !names.contains(name)) {
        let message = format!("the arm has no `{name}`");
        let help = format!("its parts are `base` and `link1` to `link{axes}`");
        return Err(refused(file, &format!("run.shapes.{name}"), message, &help));
    }
    names.iter().map(|name| shapes.get(name).map(|path| shape(file, name, path)).transpose()).collect()
}

/// Convex hulls of the shapes, for distances.
///
/// # Errors
/// A file is no mesh, or its mesh has no volume.
pub(crate) fn hulls(file: &ConfigFile, shapes: &[Option<LinkShape>]) -> Result<Vec<Option<LinkHull>>, SessionError> {
    let hull = |(name, shape): (String, &Option<LinkShape>)| {
        let Some((shape, path)) = shape.as_ref().zip(file.config.run.shapes.get(&name)) else { return Ok(None) };
        let mesh = Mesh::read(&shape.bytes).map_err(|error| format!("cannot use `{path}`: {error}"));
        let hull = mesh.and_then(|mesh| LinkHull::new(path, mesh));
        let help = "name a mesh of the link, or remove the setting: the capsules of the arm are then compared";
        hull.map(Some).map_err(|message| refused(file, &format!("run.shapes.{name}"), message, help))
    };
    link_names(shapes.len().saturating_sub(1)).zip(shapes).map(hull).collect()
}

fn shape(file: &ConfigFile, name: &str, path: &Utf8PathBuf) -> Result<LinkShape, SessionError> {
    let fault = |message: String, help: &str| refused(file, &format!("run.shapes.{name}"), message, help);
    let Some(format) = path.extension().and_then(ShapeFormat::of_extension) else {
        return Err(fault(format!("`{path}` is not a file of a known form"), "name a `.glb` or a `.stl` file"));
    };
    let path = file.folder().join(path);
    let help = "name an existing file of at most 32 MB, or remove the setting";
    let bytes = val3_files::read(&path, FileClass::Shape)
        .map_err(|reason| fault(format!("cannot read `{path}`: {reason}"), help))?;
    if !format.matches(&bytes) {
        let message = format!("`{path}` is no {} file", format.extension().to_uppercase());
        return Err(fault(message, "name a file that a CAD program has written in this form"));
    }
    Ok(LinkShape { format, bytes: bytes.into() })
}
