//! Parameters and locals of a program, for editors that display and edit them as a table.

use smol_str::SmolStr;
use val3_analysis::db::{Db, File};
use val3_analysis::items::declarations::{all_locals, all_params};
use val3_analysis::items::program::{Header, header};
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_lang::types::{BaseType, Container};
use val3_syntax::TextRange;

use crate::RefactoringError;
use crate::assists::{FixContext, added_error};
use crate::change_signature::{NewVariables, change_signature, fixed_parameters, in_code};
use crate::declare::is_old_program;
use crate::edit::SourceChange;
use crate::owner::owner;

/// Variables of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Variables {
    /// Program name.
    pub program: SmolStr,
    /// Parameters in order.
    pub parameters: Vec<ProgramVariable>,
    /// Locals in order.
    pub locals: Vec<ProgramVariable>,
    /// Names of the types that variables may have.
    pub types: Vec<SmolStr>,
    /// Whether the program has the dialect of s5 and s6, in which arrays have one dimension and collections do not
    /// exist.
    pub is_old: bool,
    /// Reason why the parameters cannot be changed, as a sentence for the user; `None` if they can.
    pub fixed: Option<String>,
}

/// A parameter or a local.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProgramVariable {
    /// Name.
    pub name: SmolStr,
    /// Type name as spelled in the file.
    pub type_name: SmolStr,
    /// Element, array or collection. A local is an array, even if it has one value.
    pub container: Container,
    /// Sizes of a local's dimensions; empty for parameters.
    pub sizes: Vec<u32>,
    /// Whether it is a parameter passed by reference.
    pub by_reference: bool,
    /// Range of the name in the declaration.
    pub range: TextRange,
    /// Number of uses in the code.
    pub uses: usize,
}

/// Parameters and locals of the program in a file; `None` if the file has no program, or if its declarations cannot be
/// read.
pub fn variables(db: &dyn Db, file: File) -> Option<Variables> {
    let project = owner(db, file)?;
    let header = header(db, file);
    if !header.complete {
        return None;
    }
    let mut types: Vec<SmolStr> = BaseType::DECLARABLE.into_iter().map(|ty| ty.name().into()).collect();
    let mut user_types: Vec<SmolStr> = items(db, project).types.keys().cloned().collect();
    user_types.sort_unstable();
    types.extend(user_types);
    Some(Variables {
        program: header.name.clone(),
        parameters: parameters(db, file, header),
        locals: locals(db, file, header),
        types,
        is_old: is_old_program(db, file),
        fixed: fixed_parameters(db, file),
    })
}

fn parameters(db: &dyn Db, file: File, header: &Header) -> Vec<ProgramVariable> {
    let params = header.params.iter().zip(all_params(db, file));
    let variables = params.map(|(param, declared)| ProgramVariable {
        name: param.name.clone(),
        type_name: param.type_name.clone(),
        container: param.container,
        sizes: Vec::new(),
        by_reference: param.by_reference,
        range: declared.range,
        uses: in_code(db, &Symbol::Param(file, param.name.clone())).len(),
    });
    variables.collect()
}

fn locals(db: &dyn Db, file: File, header: &Header) -> Vec<ProgramVariable> {
    let locals = header.locals.iter().zip(all_locals(db, file));
    let variables = locals.map(|(local, declared)| ProgramVariable {
        name: local.name.clone(),
        type_name: local.type_name.clone(),
        container: local.container,
        sizes: local.sizes.clone(),
        by_reference: false,
        range: declared.range,
        uses: in_code(db, &Symbol::Local(file, local.name.clone())).len(),
    });
    variables.collect()
}

/// Whether a local or parameter has this name.
pub(crate) fn declares_variable(header: &Header, name: &str) -> bool {
    header.locals.iter().any(|local| local.name == name) || header.params.iter().any(|param| param.name == name)
}

/// Like [`change_signature`], for a user who may choose types that do not fit the uses.
///
/// # Errors
/// Like [`change_signature`], and also if the change would add an error anywhere.
pub fn edit_variables(
    context: FixContext<'_>,
    file: File,
    wanted: &NewVariables,
) -> Result<SourceChange, RefactoringError> {
    let change = change_signature(context.db, file, wanted)?;
    // Renaming, reordering and removing variables does not change any type.
    if !wanted.adds_or_retypes(header(context.db, file)) {
        return Ok(change);
    }
    added_error(context, &change).map_or(Ok(change), |reason| Err(RefactoringError(reason)))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::testing::{MarkedListing, shown};
    use crate::{NewLocal, NewParameter};
    use val3_analysis::db::FileRange;

    const LISTING: &str = "program start()\n  num l_nSum\n  num l_nOne[2,3]\nbegin\n\
        call other(1,l_nSum)\nend\nprogram other(num x_nA,num& x_nB)\n  string l_sC\nbegin\n  $0x_nB=x_nA+x_nB\nend";

    #[test]
    fn variables_are_listed_with_their_uses() {
        let marked = MarkedListing::new(LISTING);
        let (db, file) = (marked.db(), marked.at().file);
        let found = variables(db, file).unwrap();
        let mut lines = String::new();
        for it in found.parameters.iter().chain(&found.locals) {
            let place = shown(db, FileRange { file, range: it.range });
            let (container, sizes) = (it.container, &it.sizes);
            lines += &format!("{place} {} {container:?} {sizes:?} {} {}\n", it.type_name, it.by_reference, it.uses);
        }
        expect![[r#"
            main/other.pgx:5 x_nA num Element [] false 1
            main/other.pgx:6 x_nB num Element [] true 2
            main/other.pgx:9 l_sC string Array { dims: 1 } [1] false 0
        "#]]
        .assert_eq(&lines);
        assert_eq!((found.program.as_str(), found.is_old, found.fixed), ("other", false, None));
        assert!(found.types.contains(&"mdesc".into()));
        let marked = MarkedListing::new("put(1$0)");
        assert!(variables(marked.db(), marked.at().file).unwrap().fixed.unwrap().contains("the controller"));
    }

    /// Reason why the change is rejected.
    fn refused(change: impl Fn(&mut NewVariables)) -> String {
        let marked = MarkedListing::new(LISTING);
        let (db, file) = (marked.db(), marked.at().file);
        let mut wanted = NewVariables::of(header(db, file));
        change(&mut wanted);
        let context = FixContext { db, system: &marked.system, check_cancelled: &|| {} };
        edit_variables(context, file, &wanted).map_or_else(|error| error.0, |_| "done".to_owned())
    }

    #[test]
    fn types_that_do_not_suit_are_refused() {
        expect!["it would add an error in `other.pgx`: `+` is not defined between a `string` and a `num`"]
            .assert_eq(&refused(|wanted| wanted.parameters[0].type_name = "string".to_owned()));
        expect!["it would add an error in `start.pgx`: `other` takes `x_nA` by reference and needs a variable here"]
            .assert_eq(&refused(|wanted| wanted.parameters[0].by_reference = true));
        assert_eq!(refused(|wanted| wanted.locals[0].type_name = "num".to_owned()), "done");
        assert_eq!(refused(|wanted| wanted.parameters.swap(0, 1)), "done");
    }

    #[test]
    fn arguments_that_callers_cannot_pass_are_refused() {
        expect!["it would add an error in `start.pgx`: `zUnknown` is not declared: no local variable, parameter or data has this name"].assert_eq(&added_with("zUnknown"));
        assert_eq!(added_with("l_nSum"), "done");
        let local = NewLocal { from: None, name: "l_nD".to_owned(), type_name: "num".to_owned(), sizes: vec![1] };
        assert_eq!(refused(|wanted| wanted.locals.push(local.clone())), "done");
    }

    /// Adds the parameter `x_nD`, for which each caller passes `argument`.
    fn added_with(argument: &str) -> String {
        let argument = argument.to_owned();
        refused(move |wanted| {
            wanted.parameters.push(NewParameter {
                from: None,
                name: "x_nD".to_owned(),
                type_name: "num".to_owned(),
                container: Container::Element,
                by_reference: false,
                argument: argument.clone(),
            });
        })
    }
}
