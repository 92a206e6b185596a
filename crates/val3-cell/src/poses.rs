//! Checks of numbers in a cell file: distances, poses, colours.

use val3_geometry::{IsometryMatrix3, Trsf};

use crate::error::CellError;

/// Largest accepted coordinate or distance, in mm.
const GREATEST: f64 = 1e6;

/// Checks that a length or coordinate of a shape is not larger than any cell.
pub(crate) fn check_size(number: f64, key: &str) -> Result<(), CellError> {
    if number.abs() <= GREATEST || number.is_nan() {
        return Ok(());
    }
    Err(CellError::new(key, "a number of this shape is too large", format!("{GREATEST} mm are the limit")))
}

/// Returns a distance that is neither negative nor larger than any cell.
pub(crate) fn distance(length: f64, key: &str) -> Result<f64, CellError> {
    if (0.0..=GREATEST).contains(&length) {
        return Ok(length);
    }
    Err(CellError::new(key, format!("{length} is no distance"), "write 0 or a greater number of mm"))
}

/// Converts three or six numbers to a pose.
pub(crate) fn pose(at: &[f64], key: &str) -> Result<IsometryMatrix3<f64>, CellError> {
    let (lengths, angles) = match *at {
        [] => ([0.0; 3], [0.0; 3]),
        [x, y, z] => ([x, y, z], [0.0; 3]),
        [x, y, z, rx, ry, rz] => ([x, y, z], [rx, ry, rz]),
        _ => {
            let message = format!("a pose has 3 or 6 numbers, and this has {}", at.len());
            return Err(CellError::new(key, message, "write `[x, y, z]` or `[x, y, z, rx, ry, rz]`"));
        }
    };
    if at.iter().any(|number| !number.is_finite() || number.abs() > GREATEST) {
        return Err(CellError::new(key, "a number of this pose is too large", format!("{GREATEST} mm are the limit")));
    }
    Ok(Trsf::new(lengths, angles).isometry())
}

/// Converts three numbers to the coordinates of a point or to three lengths.
pub(crate) fn triple(numbers: &[f64], key: &str) -> Result<[f64; 3], CellError> {
    numbers.try_into().map_err(|_| {
        let message = format!("three numbers are needed here, and there are {}", numbers.len());
        CellError::new(key, message, "write `[x, y, z]`")
    })
}

/// Checks that a colour has the form `#d9a400`.
pub(crate) fn check_colour(colour: &str, key: &str) -> Result<String, CellError> {
    let is_code =
        colour.strip_prefix('#').is_some_and(|code| code.len() == 6 && code.bytes().all(|c| c.is_ascii_hexdigit()));
    if is_code {
        return Ok(colour.to_owned());
    }
    let message = format!("`{colour}` is no colour");
    Err(CellError::new(format!("{key}.colour"), message, "write red, green and blue as `#d9a400`"))
}
