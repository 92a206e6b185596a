//! Effects of instructions on the arm: recording moves, waiting for them, and required references (9, 10).
//!
//! The program runs ahead of the arm: a move is recorded first and executed later (10.2).

use crate::enumerations::Enumerator;
use crate::instruction::{ArgumentForm, Family, Instruction, InstructionParam, Overload};
use crate::types::{BaseType, ValueAttribute};

/// Motion descriptor field for the axis speed, in per cent of the nominal speed, and the field's attribute in data
/// files (10.5.1).
pub const AXIS_SPEED: &str = "vel";

/// Effect of an instruction on recorded moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MotionRole {
    /// Records a move.
    Move(RequestedPath),
    /// Waits until all recorded moves are done. The arm stops there: the last move's blend is lost (9.5.4, 10.1.2.2).
    Arrive,
    /// Stops the arm; recorded moves wait until it is released (10.6).
    Stop,
    /// Releases a stopped arm (10.6).
    Restart,
    /// Discards all recorded moves and releases a stopped arm (10.6, 11.5.2).
    Reset,
    /// Returns the arm's current position (9.2.3, 9.6.3).
    Position,
    /// Returns the progress of recorded moves (10.4, 10.6).
    Progress,
}

/// Path of a move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RequestedPath {
    /// All axes start and arrive together; the arm may change its configuration.
    Joint,
    /// A line or circle of the tool; the configuration does not change (10.1.4.2).
    Cartesian,
    /// The arm yields to forces. It stops at both ends of the move, independent of the blend (11.1.4).
    Compliant,
    /// Path that is altered while the arm moves (11.2).
    Altered,
}

/// Whether the instruction needs an arm: it moves the arm, or uses its position or geometry.
#[must_use]
pub fn needs_arm(instruction: &Instruction) -> bool {
    matches!(instruction.family, Family::Motion | Family::Geometry | Family::Options)
}

/// Returns the target's position among a move's arguments: the last point or joint.
#[must_use]
pub fn target(form: &Overload) -> Option<usize> {
    form.params.iter().rposition(|param| matches!(param.ty, Some(BaseType::Point | BaseType::Joint)))
}

/// Returns the motion descriptor's position among a move's arguments.
#[must_use]
pub fn descriptor(form: &Overload) -> Option<usize> {
    form.params.iter().position(|param| param.ty == Some(BaseType::Mdesc))
}

/// Returns the tool's position among a move's arguments.
#[must_use]
pub fn tool(form: &Overload) -> Option<usize> {
    form.params.iter().position(|param| param.ty == Some(BaseType::Tool))
}

/// Whether `instruction` returns its argument point, moved by a transformation along the point's own axes (9.6.3).
#[must_use]
pub fn moves_along_own_axes(instruction: &Instruction) -> bool {
    instruction.name == "appro"
}

/// Whether the returned point has the configuration of the argument point (9.6.3).
#[must_use]
pub fn keeps_configuration(instruction: &Instruction) -> bool {
    matches!(instruction.name, "appro" | "compose")
}

/// Whether the move blends into the next move instead of stopping at its target (10.1.2.1).
#[must_use]
pub fn is_blend(choice: &Enumerator) -> bool {
    choice.ty == BaseType::Blend && choice.name != "off"
}

/// Whether this motion descriptor attribute determines the blend at the target (10.1.2).
#[must_use]
pub fn rounds_corner(attribute: &ValueAttribute) -> bool {
    matches!(attribute.field, "blend" | "leave" | "reach")
}

/// Whether the configuration is explicitly set, instead of `same` or `free` (9.7.2).
#[must_use]
pub fn is_definite(choice: &Enumerator) -> bool {
    matches!(choice.ty, BaseType::Shoulder | BaseType::Elbow | BaseType::Wrist)
        && !choice.name.ends_with("same")
        && !choice.name.ends_with("free")
}

/// Returns the run-time error for a value of this type without a reference frame or tool (9.4 to 9.6); `None` for types
/// without references.
#[must_use]
pub fn missing_reference(ty: BaseType) -> Option<u16> {
    match ty {
        BaseType::Point => Some(162),
        BaseType::Frame => Some(163),
        BaseType::Tool => Some(164),
        _ => None,
    }
}

/// Whether `instruction` fails if the argument for `param` has no reference. This applies to moves, and to other
/// instructions for which the manual lists this error.
#[must_use]
pub fn needs_reference(instruction: &Instruction, param: &InstructionParam) -> bool {
    let Some(error) = param.ty.and_then(missing_reference) else { return false };
    let is_move = matches!(instruction.role, Some(MotionRole::Move(_)));
    param.shape == ArgumentForm::Value && (instruction.errors.contains(&error) || is_move)
}

#[cfg(test)]
mod tests {
    use super::{
        Enumerator, MotionRole, RequestedPath, descriptor, is_blend, is_definite, missing_reference, needs_reference,
        rounds_corner, target,
    };
    use crate::enumerations::ENUMERATORS;
    use crate::types::{BaseType, attributes};
    use crate::{instructions, runtime_errors};

    #[test]
    fn instructions_name_their_roles() {
        let role = |name| instructions::find(name).unwrap().role;
        assert_eq!(role("alterMovej"), Some(MotionRole::Move(RequestedPath::Altered)));
        assert_eq!(role("open"), Some(MotionRole::Arrive));
        assert_eq!(role("appro"), None);
        assert_eq!(instructions::all().iter().filter(|instruction| instruction.role.is_some()).count(), 21);
    }

    #[test]
    fn moves_have_a_target_and_a_descriptor() {
        let moves =
            instructions::all().iter().filter(|instruction| matches!(instruction.role, Some(MotionRole::Move(_))));
        for form in moves.flat_map(|instruction| instruction.overloads) {
            assert!(target(form).is_some() && descriptor(form).is_some(), "{form:?}");
        }
        let circle = instructions::find("movec").unwrap();
        assert_eq!(circle.role, Some(MotionRole::Move(RequestedPath::Cartesian)));
        assert_eq!(circle.overloads.first().and_then(target), Some(1));
    }

    #[test]
    fn references_that_are_needed() {
        assert_eq!(needs("movel"), [true, true, false]);
        assert_eq!(needs("movelf"), [true, true, false, false]);
        assert_eq!(needs("setFrame"), [true, true, true, false]);
        assert_eq!(needs("link"), [false, false]);
        assert_eq!(needs("here"), [true, true]);
    }

    /// Whether each parameter of an instruction's last form needs a reference.
    fn needs(name: &str) -> Vec<bool> {
        let instruction = instructions::find(name).unwrap();
        let form = instruction.overloads.last().unwrap();
        form.params.iter().map(|param| needs_reference(instruction, param)).collect()
    }

    #[test]
    fn choices() {
        assert_eq!(names(is_blend), ["joint", "Cartesian"]);
        assert_eq!(names(is_definite), ["lefty", "righty", "epositive", "enegative", "wpositive", "wnegative"]);
    }

    fn names(is: fn(&Enumerator) -> bool) -> Vec<&'static str> {
        ENUMERATORS.iter().filter(|row| is(row)).map(|row| row.name).collect()
    }

    #[test]
    fn attributes_of_corners() {
        let shaping = attributes(BaseType::Mdesc, None).iter().filter(|attribute| rounds_corner(attribute));
        assert_eq!(shaping.map(|attribute| attribute.name).collect::<Vec<_>>(), ["blend", "leave", "reach"]);
    }

    #[test]
    fn the_errors_are_known() {
        for ty in BaseType::DECLARABLE.into_iter().filter(|ty| ty.has_father()) {
            let error = missing_reference(ty).and_then(runtime_errors::find).unwrap();
            assert!(error.short.contains("reference"), "{}", error.short);
        }
    }
}
