//! The code of a program under construction.

use std::collections::{BTreeMap, BTreeSet};

use super::model::{Container, Signature, Type, Variable, is_code};
use super::random::Random;
use super::scope::Scope;
use super::words::COMMENTS;

/// Returns the first assignment to a local of a position type, without which moves are not possible.
fn first_value(local: &Variable, scope: &Scope, random: &mut Random) -> Option<String> {
    match local.ty {
        Type::Trsf => Some("{0,0,0,0,0,0}".to_owned()),
        Type::Point | Type::Joint | Type::Frame | Type::Tool | Type::Mdesc | Type::Slot => {
            scope.readable(local.ty, random)
        }
        Type::Num | Type::Bool | Type::Text | Type::Dio => None,
    }
}

/// Returns a line that reads a variable.
fn last_use(variable: &Variable) -> Option<String> {
    let index = match variable.container {
        Container::One => "",
        Container::Array(_) => "[0]",
        Container::Grid(..) => "[0,0]",
        Container::Collection(_) => return None,
    };
    let name = &variable.name;
    Some(match variable.ty {
        Type::Num | Type::Text => format!("putln({name}{index})"),
        Type::Bool | Type::Dio => format!("wait({name}{index}==true)"),
        Type::Trsf => format!("putln({name}{index}.z)"),
        Type::Point | Type::Tool => format!("putln({name}{index}.trsf.z)"),
        Type::Joint => format!("putln({name}{index}.j1)"),
        Type::Mdesc => format!("putln({name}{index}.vel)"),
        Type::Slot => format!("putln({name}{index}.sLabel)"),
        Type::Frame => return None,
    })
}

/// A program's code so far.
pub(super) struct Body<'a> {
    pub(super) random: &'a mut Random,
    pub(super) scope: Scope,
    /// Programs that it may call.
    pub(super) callees: &'a [Signature],
    /// Locals that it may use; only the used ones are declared.
    locals: &'a [Variable],
    used_locals: BTreeSet<String>,
    /// Lines with the first assignments to locals.
    starts: BTreeMap<String, String>,
    lines: Vec<String>,
    code_lines: usize,
    depth: usize,
}

impl<'a> Body<'a> {
    /// Creates an empty body.
    pub(super) fn new(
        random: &'a mut Random,
        mut scope: Scope,
        callees: &'a [Signature],
        locals: &'a [Variable],
    ) -> Self {
        let starts = locals.iter().filter_map(|local| Some((local.name.clone(), first_value(local, &scope, random)?)));
        let starts = starts.collect();
        locals.iter().for_each(|local| scope.add(local));
        Self {
            random,
            scope,
            callees,
            locals,
            used_locals: BTreeSet::new(),
            starts,
            lines: Vec::new(),
            code_lines: 0,
            depth: 0,
        }
    }

    /// Returns the number of code lines written so far.
    pub(super) fn code_lines(&self) -> usize {
        self.code_lines
    }

    /// Returns the number of open blocks.
    pub(super) fn depth(&self) -> usize {
        self.depth
    }

    /// Writes a line at the depth of the block.
    pub(super) fn line(&mut self, text: impl AsRef<str>) {
        let indentation = "  ".repeat(self.depth + 1);
        let text = text.as_ref();
        self.code_lines += usize::from(is_code(text));
        self.lines.push(format!("{indentation}{text}"));
    }

    /// Writes a comment or a blank line in some cases.
    pub(super) fn remark(&mut self) {
        if self.random.chance(12) {
            self.lines.push(String::new());
        }
        if self.random.chance(40) {
            let comment = self.random.word(COMMENTS);
            self.line(format!("// {comment}"));
        }
    }

    /// Writes `lines` one block deeper.
    pub(super) fn deeper(&mut self, lines: impl FnOnce(&mut Self)) {
        self.depth += 1;
        lines(self);
        self.depth -= 1;
    }

    /// Marks the local at the start of `place` as used.
    pub(super) fn note(&mut self, place: String) -> String {
        let name = place.split(['[', '.']).next().unwrap_or_default();
        if self.locals.iter().any(|local| local.name == name) {
            self.used_locals.insert(name.to_owned());
        }
        place
    }

    /// Returns the lines from `begin` to `end`, and the locals to declare. At the end every variable is read once more,
    /// so that none is unused.
    pub(super) fn finish<'p>(self, parameters: impl IntoIterator<Item = &'p Variable>) -> (Vec<String>, Vec<Variable>) {
        let mut lines = vec!["begin".to_owned()];
        let starts = self.starts.iter().filter(|(local, _)| self.used_locals.contains(*local));
        lines.extend(starts.map(|(local, value)| format!("  {local}={value}")));
        lines.extend(self.lines);
        let read = self.locals.iter().filter(|local| self.used_locals.contains(&local.name)).filter_map(last_use);
        let read = read.chain(parameters.into_iter().filter_map(last_use));
        lines.extend(read.map(|line| format!("  {line}")));
        lines.push("end".to_owned());
        let used = self.locals.iter().filter(|local| self.used_locals.contains(&local.name));
        (lines, used.cloned().collect())
    }
}
