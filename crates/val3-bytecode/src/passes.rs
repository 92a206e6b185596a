//! Fast passing of arguments between programs of a project, after all their frames are known.

use val3_lang::memory::Lanes;
use val3_lang::types::BaseType;

use crate::{
    ArgumentSite, CallSite, Operand, Pass, Program, ProgramParam, ProgramRef, Register, Storage, TextOperand,
    TextSource,
};

/// Sets the fast form for the arguments in all calls that allow it.
pub fn plan_passes(programs: &mut [Program]) {
    let plain: Vec<_> = programs.iter().map(|program| program.is_plain().then(|| program.params.clone())).collect();
    for site in programs.iter_mut().flat_map(|program| &mut program.calls) {
        let callee = match site.program {
            ProgramRef::Own(number) => plain.get(usize::from(number)).and_then(Option::as_deref),
            ProgramRef::Import(_) => None,
        };
        site.passes = callee.and_then(|params| passes(params, site));
    }
}

fn passes(params: &[ProgramParam], site: &CallSite) -> Option<Vec<Pass>> {
    params.iter().zip(&site.arguments).map(|(param, argument)| pass(param, *argument)).collect()
}

fn pass(param: &ProgramParam, argument: ArgumentSite) -> Option<Pass> {
    match (param.storage, argument) {
        (Storage::Value(to), ArgumentSite::Value(from, _)) => match (param.kind.base_type()?, from) {
            (BaseType::Num | BaseType::Bool, Operand::Frame(from)) => {
                Some(Pass::Number(narrow(from.num), narrow(to.num)))
            }
            (BaseType::String, from) => Some(Pass::Text(text(from)?, narrow(to.text))),
            _ => None,
        },
        (Storage::Place(to), ArgumentSite::Value(from, _) | ArgumentSite::UserValue(from)) => {
            Some(Pass::Reference(from, to))
        }
        (Storage::View(to), ArgumentSite::View(from, start)) => Some(Pass::Container(from, start, to)),
        _ => None,
    }
}

/// Returns the operand of a string that is passed by value.
fn text(operand: Operand) -> Option<TextOperand> {
    TextOperand::new(match operand {
        Operand::Frame(lanes) => TextSource::Register(narrow(lanes.text)),
        Operand::First(container, lanes) if lanes == Lanes::default() => TextSource::First(container.kind()),
        Operand::Place(place, lanes) if lanes == Lanes::default() => TextSource::Place(place),
        Operand::First(..) | Operand::Place(..) => return None,
    })
}

/// Converts a lane to a register number; frames have no higher lanes.
fn narrow(lane: u32) -> Register {
    Register::try_from(lane).unwrap_or(Register::MAX)
}
