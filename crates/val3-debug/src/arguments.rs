//! Arguments of a program on a task's stack, as plain numbers and strings.

use val3_bytecode::{ProgramParam, Storage};
use val3_lang::memory::{KindBase, Lanes, Stack};
use val3_lang::ports::TaskNumber;
use val3_lang::types::{Arm, BaseType, Container};
use val3_vm::{Frame, Vm};

/// Argument of a built-in type, passed by value.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameArgument {
    /// Parameter name.
    pub name: String,
    /// Parameter type.
    pub base: BaseType,
    /// Kind of arm that a position is for; `None` if the type names no kind.
    pub arm: Option<Arm>,
    /// Numbers in the order of the type's fields; a `bool` is 0 or 1.
    pub nums: Vec<f64>,
    /// Value of a `string`; empty for other types.
    pub text: String,
}

/// Returns the arguments that a program on the stack received by value, in parameter order. `depth` 0 is the innermost
/// program. Arguments by reference, arrays and values of user types are omitted.
#[must_use]
pub fn arguments(vm: &Vm, task: TaskNumber, depth: usize) -> Vec<FrameArgument> {
    let Some(task) = vm.tasks().iter().find(|known| known.id == task) else { return Vec::new() };
    let Some(frame) = task.thread.frames.iter().rev().nth(depth) else { return Vec::new() };
    let image = vm.space.instance(frame.instance).map(|instance| &instance.image);
    let program = image.and_then(|image| image.programs.get(usize::from(frame.program)));
    let params = program.map(|program| program.params.as_slice()).unwrap_or_default();
    params.iter().filter_map(|param| argument(param, frame, &task.thread.stack)).collect()
}

fn argument(param: &ProgramParam, frame: &Frame, stack: &Stack) -> Option<FrameArgument> {
    let Storage::Value(Lanes { num, text, .. }) = param.storage else { return None };
    let KindBase::Builtin(base, arm) = param.kind.base else { return None };
    if param.container != Container::Element {
        return None;
    }
    let start = (frame.base.num + num) as usize;
    let nums = stack.nums.get(start..start + param.kind.size.num as usize)?.to_vec();
    let text = match param.kind.size.text {
        0 => String::new(),
        _ => stack.texts.get((frame.base.text + text) as usize)?.as_str().to_owned(),
    };
    Some(FrameArgument { name: param.name.clone(), base, arm, nums, text })
}
