//! The meaning of instructions for the arm: which record moves, which wait for it, and which need a reference (9, 10).
//!
//! The program runs ahead of the arm: a move is recorded, and the arm makes it later (10.2).

use crate::enumerations::Enumerator;
use crate::instruction::{ArgumentForm, Family, Instruction, InstructionParam, Overload};
use crate::types::{BaseType, ValueAttribute};

/// The field of a motion descriptor with the speed of the axes in per cent of the nominal one, and its attribute in data
/// files (10.5.1).
pub const AXIS_SPEED: &str = "vel";

/// The effect of an instruction on the recorded moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MotionRole {
    /// Records a move.
    Move(RequestedPath),
    /// Waits until the arm has made every recorded move. The arm stops there: a blend of the last one is lost
    /// (9.5.4, 10.1.2.2).
    Arrive,
    /// Stops the arm; what is recorded waits until it may go on (10.6).
    Stop,
    /// Lets a stopped arm go on (10.6).
    Restart,
    /// Forgets every recorded move; a stopped arm may go on (10.6, 11.5.2).
    Reset,
    /// Tells where the arm is at this moment (9.2.3, 9.6.3).
    Position,
    /// Tells how far the arm has got with the recorded moves (10.4, 10.6).
    Progress,
}

/// The path of a move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RequestedPath {
    /// All axes start and arrive together; the arm may change its configuration.
    Joint,
    /// A line or circle of the tool: the arm keeps its configuration (10.1.4.2).
    Cartesian,
    /// The arm gives way to forces. It stops at both ends of the move, whatever the blend says (11.1.4).
    Compliant,
    /// Altered while the arm moves (11.2).
    Altered,
}

/// The instruction moves the arm or asks how it is built or where it is.
#[must_use]
pub fn needs_arm(instruction: &Instruction) -> bool {
    matches!(instruction.family, Family::Motion | Family::Geometry | Family::Options)
}

/// The position of the target among the arguments of a move: its last point or joint.
#[must_use]
pub fn target(form: &Overload) -> Option<usize> {
    form.params.iter().rposition(|param| matches!(param.ty, Some(BaseType::Point | BaseType::Joint)))
}

/// The position of the motion descriptor among the arguments of a move.
#[must_use]
pub fn descriptor(form: &Overload) -> Option<usize> {
    form.params.iter().position(|param| param.ty == Some(BaseType::Mdesc))
}

/// The position of the tool among the arguments of a move.
#[must_use]
pub fn tool(form: &Overload) -> Option<usize> {
    form.params.iter().position(|param| param.ty == Some(BaseType::Tool))
}

/// `instruction` yields the point that it is given, moved by a transformation along the axes of that point (9.6.3).
#[must_use]
pub fn moves_along_own_axes(instruction: &Instruction) -> bool {
    instruction.name == "appro"
}

/// The point that `instruction` yields is reached in the configuration of the point it is given (9.6.3).
#[must_use]
pub fn keeps_configuration(instruction: &Instruction) -> bool {
    matches!(instruction.name, "appro" | "compose")
}

/// The move continues around its target instead of stopping there (10.1.2.1).
#[must_use]
pub fn is_blend(choice: &Enumerator) -> bool {
    choice.ty == BaseType::Blend && choice.name != "off"
}

/// The attribute of a motion descriptor says whether and how the corner at the target is rounded (10.1.2).
#[must_use]
pub fn rounds_corner(attribute: &ValueAttribute) -> bool {
    matches!(attribute.field, "blend" | "leave" | "reach")
}

/// The configuration is asked for outright, instead of being kept or left to the arm (9.7.2).
#[must_use]
pub fn is_definite(choice: &Enumerator) -> bool {
    matches!(choice.ty, BaseType::Shoulder | BaseType::Elbow | BaseType::Wrist)
        && !choice.name.ends_with("same")
        && !choice.name.ends_with("free")
}

/// The run-time error for a value of this type without a reference frame or tool (9.4 to 9.6); `None` for types that
/// have no reference.
#[must_use]
pub fn missing_reference(ty: BaseType) -> Option<u16> {
    match ty {
        BaseType::Point => Some(162),
        BaseType::Frame => Some(163),
        BaseType::Tool => Some(164),
        _ => None,
    }
}

/// Whether `instruction` fails where the argument for `param` has no reference: each move does, and any other
/// instruction for which the manual names such an error.
#[must_use]
pub fn needs_reference(instruction: &Instruction, param: &InstructionParam) -> bool {
    let Some(error) = param.ty.and_then(missing_reference) else { return false };
    let is_move = || matches!(instruction.role, Some(MotionRole::Move(_)));
    param.shape == ArgumentForm::Value && (instruction.errors.contains(&error) || is_move())
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
        let needs = |name: &str| {
            let instruction = instructions::find(name).unwrap();
            let form = instruction.overloads.last().unwrap();
            form.params.iter().map(|param| needs_reference(instruction, param)).collect::<Vec<_>>()
        };
        assert_eq!(needs("movel"), [true, true, false]);
        assert_eq!(needs("movelf"), [true, true, false, false]);
        assert_eq!(needs("setFrame"), [true, true, true, false]);
        assert_eq!(needs("link"), [false, false]);
        assert_eq!(needs("here"), [true, true]);
    }

    #[test]
    fn choices() {
        let names = |is: fn(&Enumerator) -> bool| {
            ENUMERATORS.iter().filter(|row| is(row)).map(|row| row.name).collect::<Vec<_>>()
        };
        assert_eq!(names(is_blend), ["joint", "Cartesian"]);
        assert_eq!(names(is_definite), ["lefty", "righty", "epositive", "enegative", "wpositive", "wnegative"]);
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
