//! Reads a program from text.

use val3_lang::types::Container;

use crate::declare::{NewProgram, NewVariable};

/// Reads a program. Names and types are not checked.
///
/// # Errors
/// The head, a local, `begin` or `end` cannot be read; the message states the line and the right form.
pub(super) fn program(text: &str) -> Result<NewProgram, String> {
    let lines: Vec<&str> = text.trim().lines().collect();
    let is = |line: &str, word: &str| line.trim().eq_ignore_ascii_case(word);
    let begin = lines.iter().position(|line| is(line, "begin")).ok_or("the line `begin` before the code is missing")?;
    let (head, code) = lines.split_at(begin);
    let code = match code.split_last() {
        Some((last, code)) if is(last, "end") => code.get(1..).unwrap_or_default(),
        _ => return Err("the last line must be `end`".to_owned()),
    };
    let (head, locals) =
        head.split_first().ok_or("the first line must be the head of the program: program pick(num x_n)")?;
    let mut program =
        NewProgram { code: code.iter().map(|&line| line.trim_end().to_owned()).collect(), ..read_head(head)? };
    for line in locals.iter().map(|line| line.trim()).filter(|line| !line.is_empty()) {
        let (variable, by_reference) = declaration(line, false)?;
        if by_reference {
            return Err(format!("`{line}`: a local is no reference"));
        }
        program.locals.push(variable);
    }
    Ok(program)
}

fn read_head(line: &str) -> Result<NewProgram, String> {
    let Some(ProgramHead { public, name, params }) = ProgramHead::split(line) else {
        return Err(format!(
            "`{line}` is no head of a program: write [public] program pick(num x_nCount, string& x_sName, num x_nList[])"
        ));
    };
    let params = if params.is_empty() { Vec::new() } else { parameters(params)? };
    Ok(NewProgram { name: name.to_owned(), public, params, ..NewProgram::default() })
}

/// Parts of a program's first line.
struct ProgramHead<'l> {
    public: bool,
    name: &'l str,
    /// Text between the parentheses.
    params: &'l str,
}

impl<'l> ProgramHead<'l> {
    /// Splits the line; `None` if a part is missing. Without `public`, the program is private.
    fn split(line: &'l str) -> Option<Self> {
        let rest = line.trim();
        let (public, rest) = match rest.strip_prefix("public ") {
            Some(rest) => (true, rest.trim_start()),
            None => (false, rest.strip_prefix("private ").unwrap_or(rest).trim_start()),
        };
        let (name, params) = rest.strip_prefix("program ")?.split_once('(')?;
        Some(Self { public, name: name.trim(), params: params.trim_end().strip_suffix(')')?.trim() })
    }
}

/// Reads parameters, which are separated by commas outside of brackets.
fn parameters(text: &str) -> Result<Vec<(NewVariable, bool)>, String> {
    let mut depth = 0_usize;
    let parts = text.split(|character| {
        match character {
            '[' => depth += 1,
            ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        character == ',' && depth == 0
    });
    parts.map(|part| declaration(part.trim(), true)).collect()
}

/// Reads `num l_n`, `point l_p[3]`, and of parameters also `num& x_n`, `num x_n[]`, `num x_n[,]`, `num x_n[""]`. Returns
/// also whether the variable is a reference.
fn declaration(text: &str, is_parameter: bool) -> Result<(NewVariable, bool), String> {
    let form = if is_parameter {
        "num x_n, num& x_n, num x_n[], num x_n[,] or num x_n[\"\"]"
    } else {
        "num l_n or num l_n[3]"
    };
    let wrong = || format!("`{text}` is no declaration: write {form}");
    let (type_name, rest) = text.split_once(char::is_whitespace).ok_or_else(wrong)?;
    let rest = rest.trim();
    let (type_name, rest) = match (type_name.strip_suffix('&'), rest.strip_prefix('&')) {
        (None, None) => (type_name, Ok(rest)),
        (Some(type_name), _) => (type_name, Err(rest)),
        (None, Some(rest)) => (type_name, Err(rest.trim_start())),
    };
    let is_reference = rest.is_err();
    let (Ok(rest) | Err(rest)) = rest;
    let (name, inside) = match rest.split_once('[') {
        None => (rest, None),
        Some((name, inside)) => (name, Some(inside.trim_end().strip_suffix(']').ok_or_else(wrong)?)),
    };
    let (container, sizes) = match inside {
        None if is_parameter => (Container::Element, vec![1]),
        None => (Container::Array { dims: 1 }, vec![1]),
        Some("\"\"") if is_parameter => (Container::Collection, Vec::new()),
        Some(inside) => array(inside, is_parameter).ok_or_else(wrong)?,
    };
    let variable = NewVariable { name: name.trim().to_owned(), type_name: type_name.to_owned(), container, sizes };
    Ok((variable, is_reference || container != Container::Element && is_parameter))
}

/// Reads the sizes of a local array, or the commas of a parameter.
fn array(inside: &str, is_parameter: bool) -> Option<(Container, Vec<u32>)> {
    let parts: Vec<&str> = inside.split(',').map(str::trim).collect();
    let dims = u8::try_from(parts.len()).ok().filter(|dims| *dims <= 3)?;
    // A parameter has no sizes, but `&` and the number of dimensions.
    let size = |part: &&str| if is_parameter { Some(2) } else { part.parse().ok().filter(|size| *size > 0) };
    Some((Container::Array { dims }, parts.iter().map(size).collect::<Option<_>>()?))
}
