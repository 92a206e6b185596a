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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ContainerKind, ContainerRef, assemble};

    /// Returns the fast form of a call's arguments, for a program with these parameters and this frame.
    fn passes(params: &str, frame: &str, arguments: &str) -> Option<Vec<Pass>> {
        let text = format!(
            "data sName string[1]\ndata nList num[3]\n\
             program start\nframe n9/t9/p9/v9\nCall callee ({arguments})\nReturn\nend\n\
             program callee\n{params}\n{frame}\nReturn\nend"
        );
        assemble(&text).unwrap().programs[0].calls[0].passes.clone()
    }

    fn text(source: TextSource) -> TextOperand {
        TextOperand::new(source).unwrap()
    }

    #[test]
    fn numbers_and_strings_are_copied() {
        let params = "param x_n num n2\nparam x_b bool n3\nparam x_s string t1";
        let expected = |source| vec![Pass::Number(5, 2), Pass::Number(6, 3), Pass::Text(text(source), 1)];
        for (argument, source) in [
            ("t4", TextSource::Register(4)),
            ("$sName", TextSource::First(ContainerKind::Data(0))),
            ("p3", TextSource::Place(3)),
        ] {
            let found = passes(params, "frame n4/t2", &format!("num n5, bool n6, string {argument}"));
            assert_eq!(found, Some(expected(source)), "{argument}");
        }
    }

    #[test]
    fn values_and_containers_are_passed_by_reference() {
        let params = "param x_n num p1\nparam x_l num[] v2";
        let found = passes(params, "frame p2/v3", "num n5, view $nList from n6");
        let list = ContainerRef::new(ContainerKind::Data(1)).unwrap();
        let number = Operand::Frame(Lanes { num: 5, ..Lanes::default() });
        assert_eq!(found, Some(vec![Pass::Reference(number, 1), Pass::Container(list, Some(6), 2)]));
    }

    #[test]
    fn other_arguments_have_no_fast_form() {
        for (params, frame, arguments) in [
            ("param x_n num n0", "frame n1", "num $nList"),
            ("param x_s string t0", "frame t1", "string $sName+t1"),
            ("param x_t trsf n0", "frame n6", "trsf n0"),
            ("param x_n num n0", "frame n1/l1", "num n0"),
            ("param x_n num n0", "frame n1\ncontainer num[1]", "num n0"),
        ] {
            assert_eq!(passes(params, frame, arguments), None, "{params}: {arguments}");
        }
    }

    #[test]
    fn programs_of_libraries_have_no_fast_form() {
        let text = "library l \"l\"\nimport l p program ()\nprogram start\nCall import 0 ()\nReturn\nend";
        assert_eq!(assemble(text).unwrap().programs[0].calls[0].passes, None);
    }
}
