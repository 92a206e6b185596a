//! Run-time handlers of operators that have no operation in the virtual machine.
//!
//! Their arguments are the operands, from left to right; an assignment that only reads has only the value.

use val3_geometry::Trsf;

use super::{BinaryOp, UnaryOp};
use crate::call::{
    Argument, Call, Flow, FrameRef, FromArgument, HandlerResult, InstructionFn, IoRef, PointRef, ToolRef,
};
use crate::fault::{Fault, Result};
use crate::memory::{Lanes, Memory, Place, ValueType};
use crate::types::{Arm, BaseType};
use crate::values::{JointValue, printed};

/// Difference up to which axes count as equal, in degrees and the length unit of the application: the resolution of an arm. The manual states no number
/// (9.2.2).
pub const ARM_PRECISION: f64 = 1e-4;

/// Handler of `left op right` for positions of this arm; `None` if values are compared field by field or by an
/// operation.
#[must_use]
pub fn binary(op: BinaryOp, base: BaseType, arm: Option<Arm>) -> Option<InstructionFn> {
    use BaseType::{Frame, Joint, Point, Tool, Trsf};
    use BinaryOp::{Add, Equal, Greater, Less, Multiply, NotEqual, Subtract};
    Some(match (op, base) {
        (Multiply, Trsf) => |call| two(call, |a: self::Trsf, b| a * b),
        (Add, Joint) => |call| two(call, |a, b| each(a, b, |a, b| a + b)),
        (Subtract, Joint) => |call| two(call, |a, b| each(a, b, |a, b| a - b)),
        (Less, Joint) if arm == Some(Arm::Scara) => |call| two(call, |a, b| all::<4>(a, b, |a, b| a < b)),
        (Less, Joint) => |call| two(call, |a, b| all::<6>(a, b, |a, b| a < b)),
        (Greater, Joint) if arm == Some(Arm::Scara) => |call| two(call, |a, b| all::<4>(a, b, |a, b| a > b)),
        (Greater, Joint) => |call| two(call, |a, b| all::<6>(a, b, |a, b| a > b)),
        (Equal, Joint) => |call| two(call, is_same_position),
        (NotEqual, Joint) => |call| two(call, |a, b| !is_same_position(a, b)),
        (Equal, Frame) => |call| related(call, |FrameRef(a), FrameRef(b)| (a, b), Lanes::nums(6), 1, true),
        (NotEqual, Frame) => |call| related(call, |FrameRef(a), FrameRef(b)| (a, b), Lanes::nums(6), 1, false),
        (Equal, Tool) => |call| related(call, |ToolRef(a), ToolRef(b)| (a, b), Lanes::nums(8), 2, true),
        (NotEqual, Tool) => |call| related(call, |ToolRef(a), ToolRef(b)| (a, b), Lanes::nums(8), 2, false),
        (Equal, Point) => |call| related(call, |PointRef(a), PointRef(b)| (a, b), Lanes::nums(6), 1, true),
        (NotEqual, Point) => |call| related(call, |PointRef(a), PointRef(b)| (a, b), Lanes::nums(6), 1, false),
        _ => return None,
    })
}

/// Handler of `op operand`.
#[must_use]
pub fn unary(op: UnaryOp, base: BaseType) -> Option<InstructionFn> {
    match (op, base) {
        (UnaryOp::Not, BaseType::Trsf) => Some(|call| Trsf::take(call)?.inverse().settle(call)),
        _ => None,
    }
}

/// Handler of `target = value`, if it reads or writes an input or output.
#[must_use]
pub fn assignment(target: BaseType, value: BaseType) -> Option<InstructionFn> {
    match (target, value) {
        (BaseType::Bool, BaseType::Dio) => Some(|call| {
            let input = IoRef::take(call)?;
            call.ports.read_digital(input.port).settle(call)
        }),
        (BaseType::Dio, BaseType::Bool) => Some(|call| {
            let (output, state) = (IoRef::take(call)?, bool::take(call)?);
            call.ports.write_digital(output.port, state).settle(call)
        }),
        _ => super::serial::assignment(target, value),
    }
}

/// Handler of a line that uses a library item which no file declares (6.4).
///
/// # Errors
/// 80, always.
pub fn missing_item(_: &mut Call<'_>) -> Result<Flow> {
    Err(Fault::LIBRARY_ITEM_MISSING)
}

/// Handler of a line that is accepted but has no meaning.
///
/// # Errors
/// 61, always.
pub fn not_executable(_: &mut Call<'_>) -> Result<Flow> {
    Err(Fault::INTERPRETER)
}

/// Handler of `?` for positions of this arm.
#[must_use]
pub fn print(arm: Option<Arm>) -> InstructionFn {
    match arm {
        Some(Arm::Scara) => |call| printed_line(call, Some(Arm::Scara)),
        _ => |call| printed_line(call, None),
    }
}

/// Prints a line: strings without quotes, an input's state, and other values in VAL 3 notation.
fn printed_line(call: &mut Call<'_>, arm: Option<Arm>) -> Result<Flow> {
    let line = match call.argument()? {
        Argument::Value(place, BaseType::String) => call.memory.text(place)?.to_string(),
        Argument::Value(place, BaseType::Dio) => {
            let input = <IoRef as crate::call::StoredValue>::read(call.memory, place)?;
            printed::bool(call.ports.read_digital(input.port)?).to_owned()
        }
        Argument::Value(place, base) => call.memory.shown(&ValueType::builtin(base, arm), place)?,
        Argument::UserValue(place) => {
            let kind = call.memory.store(place.store)?.kind.clone();
            call.memory.shown(&kind, place)?
        }
        _ => return Err(Fault::INTERPRETER),
    };
    call.ports.print(&line);
    Ok(Flow::Done(()))
}

/// Reads both operands and computes the result.
fn two<T: FromArgument, O: HandlerResult>(call: &mut Call<'_>, compute: impl FnOnce(T, T) -> O) -> Result<Flow> {
    let (a, b) = (T::take(call)?, T::take(call)?);
    compute(a, b).settle(call)
}

fn each(JointValue(a): JointValue, JointValue(b): JointValue, compute: impl Fn(f64, f64) -> f64) -> JointValue {
    let mut result = a;
    result.iter_mut().zip(b).for_each(|(a, b)| *a = compute(*a, b));
    JointValue(result)
}

/// Whether the condition is true for all existing axes.
fn all<const AXES: usize>(
    JointValue(a): JointValue,
    JointValue(b): JointValue,
    suits: impl Fn(f64, f64) -> bool,
) -> bool {
    a.into_iter().zip(b).take(AXES).all(|(a, b)| suits(a, b))
}

fn is_same_position(a: JointValue, b: JointValue) -> bool {
    all::<6>(a, b, |a, b| (a - b).abs() <= ARM_PRECISION)
}

/// Compares frames, points or tools: frames and points are equal if they have the same position in the same frame;
/// tools if they have the same position on the same tool, and the same gripper and times (9.4.3, 9.5.3, 9.6.2). `nums`
/// and `links` are the compared lanes. The configuration of a point is not compared.
fn related<T: FromArgument>(
    call: &mut Call<'_>,
    places: impl FnOnce(T, T) -> (Place, Place),
    nums: Lanes,
    links: u32,
    when: bool,
) -> Result<Flow> {
    let (a, b) = (T::take(call)?, T::take(call)?);
    let (a, b) = places(a, b);
    let equal = alike(call.memory, a, b, nums.num, links)?;
    (equal == when).settle(call)
}

fn alike(memory: &Memory, a: Place, b: Place, nums: u32, links: u32) -> Result<bool> {
    for lane in 0..nums {
        if memory.num(a, lane)? != memory.num(b, lane)? {
            return Ok(false);
        }
    }
    for lane in 0..links {
        if memory.link(a, lane)? != memory.link(b, lane)? {
            return Ok(false);
        }
    }
    Ok(true)
}
