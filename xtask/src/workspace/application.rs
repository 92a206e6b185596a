//! An application: data, then programs that call later ones.

use std::collections::BTreeSet;

use super::body::Body;
use super::model::{Container, Data, Parameter, Program, Project, Signature, Type, Variable};
use super::random::Random;
use super::scope::Scope;
use super::shared;
use super::words::{NOUNS, VERBS};

/// Requested properties of the application.
pub(super) struct ApplicationPlan {
    /// Number, from which its name is derived.
    pub(super) number: usize,
    /// Number of code lines from which on no further program is begun.
    pub(super) most_lines: usize,
}

/// Types of data with their number per application.
const DATA: &[(Type, usize)] = &[
    (Type::Num, 24),
    (Type::Bool, 12),
    (Type::Text, 12),
    (Type::Point, 12),
    (Type::Joint, 5),
    (Type::Trsf, 5),
    (Type::Frame, 3),
    (Type::Tool, 2),
    (Type::Mdesc, 4),
    (Type::Dio, 4),
    (Type::Slot, 3),
];

/// Types of parameters with their frequency.
const PARAMETERS: &[(usize, Type)] =
    &[(50, Type::Num), (20, Type::Text), (15, Type::Bool), (10, Type::Point), (5, Type::Slot)];

/// Generates an application.
pub(super) fn build(plan: &ApplicationPlan, random: &mut Random) -> Project {
    let name = format!("cell{:03}", plan.number);
    let data = data(random);
    let mut signatures = signatures(random);
    let scope = Scope::of_application(&data);
    let mut programs = vec![start(), stop()];
    let mut lines = 0;
    while let Some(signature) = signatures.pop() {
        if lines >= plan.most_lines {
            break;
        }
        let program = program(signature, &programs, &scope, random);
        lines += program.lines.len();
        programs.push(program);
    }
    Project {
        folder: name.clone(),
        name,
        data,
        programs,
        libraries: vec![shared::IO, shared::LOGBOOK],
        types: vec![shared::SLOT],
    }
}

fn data(random: &mut Random) -> Vec<Data> {
    let mut names = Names::default();
    let kinds = DATA.iter().flat_map(|(ty, count)| std::iter::repeat_n(*ty, *count));
    kinds
        .map(|ty| {
            let name = names.fresh(ty.prefix(), random);
            let variable = Variable { name, ty, container: container(ty, random) };
            Data { variable, public: random.chance(30) }
        })
        .collect()
}

fn container(ty: Type, random: &mut Random) -> Container {
    match (ty, random.below(10)) {
        (Type::Num, 0) => Container::Grid(random.between(3, 6), random.between(3, 8)),
        (Type::Text, 0) => Container::Collection(&["idle", "alarm", "run"]),
        (Type::Slot, _) => Container::Array(random.between(3, 10)),
        (Type::Num | Type::Text | Type::Bool | Type::Point | Type::Joint, 1..=3) => {
            Container::Array(random.between(3, 20))
        }
        _ => Container::One,
    }
}

/// Names that are used once.
#[derive(Default)]
struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// Returns a unique name of at most 15 characters.
    fn fresh(&mut self, prefix: &str, random: &mut Random) -> String {
        loop {
            let name = format!("{prefix}{}{}", random.word(NOUNS), random.word(NOUNS));
            if name.len() <= 15 && self.taken.insert(name.clone()) {
                return name;
            }
        }
    }
}

fn signatures(random: &mut Random) -> Vec<Signature> {
    let mut names = Names::default();
    let count = random.between(20, 60);
    let each = (0..count).map(|_| {
        let verb = random.word(VERBS);
        let name = names.fresh(verb, random);
        Signature { name, parameters: parameters(random) }
    });
    each.collect()
}

fn parameters(random: &mut Random) -> Vec<Parameter> {
    let most = if random.chance(50) { 0 } else { 4 };
    let mut names = Names::default();
    (0..random.between(0, most))
        .map(|_| {
            let ty = random.weighted(PARAMETERS).unwrap_or(Type::Num);
            let is_array = ty == Type::Num && random.chance(30);
            let container = if is_array { Container::Array(3) } else { Container::One };
            let name = names.short(ty, random);
            Parameter { variable: Variable { name, ty, container }, by_reference: is_array || random.chance(30) }
        })
        .collect()
}

impl Names {
    /// Returns a unique parameter name: `x_nCount`.
    fn short(&mut self, ty: Type, random: &mut Random) -> String {
        loop {
            let name = format!("x_{}{}", ty.prefix(), random.word(NOUNS));
            if self.taken.insert(name.clone()) {
                return name;
            }
        }
    }
}

/// Generates a program that may call earlier programs in the list, so that calls are never recursive.
fn program(signature: Signature, earlier: &[Program], scope: &Scope, random: &mut Random) -> Program {
    let mut callees = shared::library_programs();
    callees.extend(earlier.iter().skip(2).map(|program| program.signature.clone()));
    let mut scope = scope.clone();
    signature.parameters.iter().for_each(|parameter| scope.add_parameter(parameter));
    let public = random.chance(50);
    let wanted = length(random);
    let locals = locals();
    let mut body = Body::new(random, scope, &callees, &locals);
    while body.code_lines() < wanted {
        body.statement();
    }
    let (lines, locals) = body.finish(signature.parameters.iter().map(|parameter| &parameter.variable));
    Program { signature, public, locals, lines }
}

/// Returns the number of code lines of a program: most are short, a few long.
fn length(random: &mut Random) -> usize {
    match random.below(10) {
        0..=5 => random.between(4, 16),
        6..=8 => random.between(16, 40),
        _ => random.between(40, 120),
    }
}

fn locals() -> Vec<Variable> {
    let mut locals: Vec<_> = ["l_i", "l_j", "l_k", "l_nA", "l_nB"].map(|name| Variable::one(name, Type::Num)).to_vec();
    locals.push(Variable { name: "l_nList".to_owned(), ty: Type::Num, container: Container::Array(10) });
    locals.push(Variable::one("l_sText", Type::Text));
    locals.push(Variable::one("l_bOk", Type::Bool));
    locals.push(Variable::one("l_pTarget", Type::Point));
    locals.push(Variable::one("l_trShift", Type::Trsf));
    locals
}

fn start() -> Program {
    let lines = ["begin", "  enablePower()", "  wait(isPowered())", "  taskCreate \"clean\",20,stop()", "end"];
    bare("start", &lines)
}

fn stop() -> Program {
    bare("stop", &["begin", "  resetMotion()", "  popUpMsg(\"stopped\")", "end"])
}

fn bare(name: &str, lines: &[&str]) -> Program {
    let signature = Signature { name: name.to_owned(), parameters: Vec::new() };
    let lines = lines.iter().map(|line| (*line).to_owned()).collect();
    Program { signature, public: false, locals: Vec::new(), lines }
}
