//! Calls between programs of a project, once the frames of all of them are known.

use val3_bytecode::{ArgumentSite, CallSite, Operand, Pass, Passing, Program, ProgramRef};
use val3_lang::types::BaseType;

use crate::frame::narrow;

/// Finds out what calls do for their arguments where that is quick.
pub(crate) fn plan(programs: &mut [Program]) {
    let passings = |program: &Program| program.params.iter().map(|param| param.passing).collect::<Vec<_>>();
    let plain: Vec<_> = programs.iter().map(|program| program.is_plain().then(|| passings(program))).collect();
    for site in programs.iter_mut().flat_map(|program| &mut program.calls) {
        let callee = match site.program {
            ProgramRef::Own(number) => plain.get(usize::from(number)).and_then(Option::as_deref),
            ProgramRef::Import(_) => None,
        };
        site.passes = callee.and_then(|passings| passes(passings, site));
    }
}

fn passes(params: &[Passing], site: &CallSite) -> Option<Vec<Pass>> {
    params.iter().zip(&site.arguments).map(|(param, argument)| pass(*param, *argument)).collect()
}

fn pass(param: Passing, argument: ArgumentSite) -> Option<Pass> {
    match (param, argument) {
        (Passing::Value(BaseType::Num | BaseType::Bool, to), ArgumentSite::Value(Operand::Frame(from), _)) => {
            Some(Pass::Number(narrow(from.num), narrow(to.num)))
        }
        (Passing::Reference(to), ArgumentSite::Value(from, _)) => Some(Pass::Reference(from, to)),
        _ => None,
    }
}
