//! A new test in a test application: its program, its element in the project file, and its call in `start`.

use smol_str::SmolStr;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::parse;
use val3_analysis::items::program::{ParamDecl, header};
use val3_analysis::items::project::{folder, items};
use val3_analysis::test_applications::has_tests;
use val3_lang::keywords::is_identifier;
use val3_lang::test_names::{ASSERTIONS, is_test};
use val3_lang::types::{Arm, BaseType, Container};
use val3_lang::versions::Version;
use val3_syntax::{SyntaxKind, TextRange};

use crate::RefactoringError;
use crate::declare::{self, NewProgram, NewVariable};
use crate::edit::{FileEdit, SourceChange};
use crate::file_operations::relative;
use crate::folding::find_code;

/// Program that calls the tests on a controller.
const START: &str = "start";

/// Creates a test called `name` in a test application. `tested` is the program that it calls, for example `total` or
/// `pal:total`. The test has a local variable for each parameter, and an assertion for each output, whose expected
/// value the user fills in.
///
/// # Errors
/// The reason why the test cannot be created, as a sentence without its full stop.
pub fn new_test(
    db: &dyn Db,
    project: Project,
    name: &str,
    tested: Option<&str>,
) -> Result<SourceChange, RefactoringError> {
    if !has_tests(db, project) {
        return Err("it is no test application".into());
    }
    if !is_identifier(name) || !is_test(name) {
        return Err(format!("`{name}` is no name of a test: it begins with `test`, as in `testTotal`").into());
    }
    if items(db, project).programs.keys().any(|known| known.eq_ignore_ascii_case(name)) {
        return Err(format!("it has a program `{name}`").into());
    }
    let assert = alias_of_assertions(db, project)
        .ok_or_else(|| format!("it does not load the library `{ASSERTIONS}`: `val3 test --init` writes one"))?;
    let TestBody { locals, code, types } = match tested {
        Some(tested) => body(db, project, &assert, tested)?,
        None => TestBody { code: vec![unfinished(&assert)], ..TestBody::default() },
    };
    let program = NewProgram {
        name: name.to_owned(),
        public: true,
        locals,
        code,
        line_end: line_end(db, project.manifest(db)),
        ..NewProgram::default()
    };
    let mut change = declare::programs(db, project, &[program]).ok_or("its project file has no list of programs")?;
    change.edits.extend(call_in_start(db, project, name));
    if !types.is_empty() {
        change.edits.push(declare::user_types(db, project, &types).ok_or("its project file has no list of types")?);
    }
    Ok(change.sorted(db))
}

/// A line that fails until the test is completed.
fn unfinished(assert: &str) -> String {
    format!("  call {assert}:fail(\"this test is not written yet\")")
}

/// Library identifier of the assertions.
fn alias_of_assertions(db: &dyn Db, project: Project) -> Option<SmolStr> {
    let libraries = items(db, project).libraries.iter();
    let assertions = libraries.filter(|(_, item)| item.interface.is_some_and(|library| is_assertions(db, library)));
    assertions.map(|(alias, _)| alias).min().cloned()
}

/// Whether the project is the library of assertions.
fn is_assertions(db: &dyn Db, library: Project) -> bool {
    library.manifest(db).path(db).file_stem() == Some(ASSERTIONS)
}

/// Local variables and code lines of a test.
#[derive(Default)]
struct TestBody {
    locals: Vec<NewVariable>,
    code: Vec<String>,
    /// User types that the test application must declare, as name and path.
    types: Vec<(String, String)>,
}

/// The tested program.
#[derive(Clone)]
struct TestedProgram {
    alias: SmolStr,
    project: Project,
    file: File,
}

/// Body of the test for a program of a library.
fn body(db: &dyn Db, project: Project, assert: &str, tested: &str) -> Result<TestBody, RefactoringError> {
    let TestedProgram { alias, project: tested_project, file } = find(db, project, assert, tested)?;
    let called = header(db, file);
    let mut body = TestBody::default();
    let (mut arguments, mut assertions) = (Vec::new(), Vec::new());
    for param in &called.params {
        let local = local_name(&param.name);
        let base = BaseType::from_file_name(&param.type_name).map(|(base, _)| base);
        if base.is_none() && !items(db, project).types.contains_key(&param.type_name) {
            let entry = user_type(db, project, tested_project, param)?;
            if !body.types.contains(&entry) {
                body.types.push(entry);
            }
        }
        body.locals.push(variable(&local, param));
        body.code
            .extend(base.filter(|_| !is_output(param)).and_then(default).map(|value| format!("  {local}={value}")));
        if is_output(param) {
            let expected = expected_name(&local, body.locals.len(), items(db, project).version);
            if needs_expected(param, base) {
                body.locals.push(variable(&expected, param));
            }
            assertions.push(assertion(assert, &local, &expected, param, base));
        }
        arguments.push(local);
    }
    if assertions.is_empty() {
        assertions.push(unfinished(assert));
    } else {
        assertions.insert(0, "  // Fill in the expected values".to_owned());
    }
    body.code.push(format!("  call {alias}:{}({})", called.name, arguments.join(",")));
    body.code.extend(assertions);
    Ok(body)
}

/// Finds the library identifier and the file of the tested program.
fn find(db: &dyn Db, project: Project, assert: &str, tested: &str) -> Result<TestedProgram, RefactoringError> {
    let (wanted, name) = tested.split_once(':').map_or((None, tested), |(alias, name)| (Some(alias), name));
    let libraries = &items(db, project).libraries;
    let mut found: Vec<TestedProgram> = libraries
        .iter()
        .filter(|(alias, _)| alias.as_str() != assert && wanted.is_none_or(|wanted| wanted == alias.as_str()))
        .filter_map(|(alias, item)| {
            let project = item.interface?;
            Some(TestedProgram { alias: alias.clone(), project, file: *items(db, project).programs.get(name)? })
        })
        .collect();
    found.sort_by(|one, other| one.alias.cmp(&other.alias));
    match found.as_slice() {
        [one] => Ok(one.clone()),
        [] => Err(format!("none of its libraries has a program `{tested}`").into()),
        several => {
            let names: Vec<String> = several.iter().map(|found| format!("`{}:{name}`", found.alias)).collect();
            Err(format!("several of its libraries have the program: name one of {}", names.join(", ")).into())
        }
    }
}

/// Name and path of a parameter's user type.
fn user_type(
    db: &dyn Db,
    project: Project,
    tested: Project,
    param: &ParamDecl,
) -> Result<(String, String), RefactoringError> {
    let ParamDecl { name, type_name, .. } = param;
    let unknown = || format!("`{name}` has the type `{type_name}`, which cannot be found");
    let declared = items(db, tested).types.get(type_name).copied().flatten().ok_or_else(unknown)?;
    let path = relative(folder(db, project), declared.manifest(db).path(db)).ok_or_else(unknown)?;
    Ok((type_name.to_string(), path))
}

/// Name of the local for a parameter: `l_nSum` for `x_nSum`.
fn local_name(parameter: &str) -> String {
    format!("l_{}", parameter.strip_prefix("x_").unwrap_or(parameter))
}

/// Variable name for an output's expected value. Versions may limit the length.
fn expected_name(local: &str, number: usize, version: Version) -> String {
    let limit = version.identifier_limit().unwrap_or(usize::MAX);
    let name = format!("{local}Expected");
    if name.len() <= limit { name } else { format!("l_expected{number}") }
}

/// Variable that can be passed for a parameter.
fn variable(name: &str, param: &ParamDecl) -> NewVariable {
    let single = NewVariable::single(name, &param.type_name);
    match param.container {
        Container::Array { dims } => {
            NewVariable { sizes: vec![2; usize::from(dims)], container: param.container, ..single }
        }
        Container::Element | Container::Collection => single,
    }
}

/// Whether the program may change the argument.
fn is_output(param: &ParamDecl) -> bool {
    param.by_reference
}

/// Initial value, for types with literals.
fn default(base: BaseType) -> Option<&'static str> {
    match base {
        BaseType::Num => Some("0"),
        BaseType::Bool => Some("false"),
        BaseType::String => Some("\"\""),
        _ => None,
    }
}

/// Whether the assertion requires a variable for its expected value.
fn needs_expected(param: &ParamDecl, base: Option<BaseType>) -> bool {
    let is_array = param.container != Container::Element;
    matches!(base, Some(BaseType::Num | BaseType::String)) && is_array || base == Some(BaseType::Point) && !is_array
}

/// Assertion for an output.
fn assertion(assert: &str, local: &str, expected: &str, param: &ParamDecl, base: Option<BaseType>) -> String {
    let call = match (base, param.container) {
        (Some(BaseType::Num), Container::Element) => format!("equalNum({local},0,0.001)"),
        (Some(BaseType::String), Container::Element) => format!("equalString({local},\"\")"),
        (Some(BaseType::Bool), Container::Element) => format!("equalBool({local},true)"),
        (Some(BaseType::Joint), Container::Element) if param.type_name.ends_with(Arm::Scara.suffix()) => {
            format!("equalJoint({local},{{0,0,0,0}},0.01)")
        }
        (Some(BaseType::Joint), Container::Element) => format!("equalJoint({local},{{0,0,0,0,0,0}},0.01)"),
        (Some(BaseType::Trsf), Container::Element) => format!("equalTrsf({local},{{0,0,0,0,0,0}},0.01,0.01)"),
        (Some(BaseType::Point), Container::Element) => format!("equalPose({local},{expected},0.01,0.01)"),
        (Some(BaseType::Num), Container::Array { dims: 1 }) => format!("equalNums({local},{expected},0.001)"),
        (Some(BaseType::String), Container::Array { dims: 1 }) => format!("equalStrings({local},{expected})"),
        _ => format!("fail(\"state what `{local}` has to be\")"),
    };
    format!("  call {assert}:{call}")
}

/// Edit that calls the test at the end of `start`; `None` without this program.
fn call_in_start(db: &dyn Db, project: Project, name: &str) -> Option<FileEdit> {
    let file = *items(db, project).programs.get(START)?;
    let parse = parse(db, file);
    let end = find_code(parse.view())?.token(SyntaxKind::END_KW)?.range().start();
    Some(FileEdit { file, range: TextRange::empty(end), text: format!("  call {name}(){}", line_end(db, file)) })
}

/// Line end of a file.
fn line_end(db: &dyn Db, file: File) -> &'static str {
    if file.text(db).contains("\r\n") { "\r\n" } else { "\n" }
}
