//! Adds missing interface items to a library that is loaded for the interface.

use smol_str::SmolStr;
use val3_analysis::db::{Project, Sources};
use val3_analysis::interfaces;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{find_project, items};
use val3_analysis::problem::{NameKind, ProblemKind};
use val3_lang::types::Container;

use super::context::Context;
use super::{AssistKind, Assists};
use crate::declare::{self, NewProgram, NewVariable};
use crate::edit::SourceChange;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let found = interfaces::problems(context.db, context.project).iter().find_map(|problem| match &problem.kind {
        ProblemKind::ImplementationMissing { alias, library, items } => {
            let here = problem.place.file == context.file && problem.place.range.intersect(context.range).is_some();
            here.then_some((problem.place.range, alias, library, items))
        }
        _ => None,
    });
    let (place, alias, library, missing) = found?;
    let interface = context.items().libraries.get(alias)?.interface?;
    let target = loaded(context, place, library)?;
    let title = format!("Add missing items of the interface of `{alias}` to `{library}`");
    assists.add("add-missing-items", AssistKind::QuickFix, title, || add(context, interface, target, missing));
    Some(())
}

/// Library that is loaded at `place`.
fn loaded(context: &Context<'_>, place: val3_syntax::TextRange, library: &str) -> Option<Project> {
    let loads = &interfaces::uses(context.db, context.file).loads;
    let load = loads.iter().find(|load| load.range == place)?;
    if let interfaces::LoadedPath::Whole(path) = &load.path {
        return find_project(context.db, context.project, path);
    }
    let db = context.db;
    let mut named: Vec<Project> = Sources::get(db).projects(db).values().copied().collect();
    named.retain(|project| project.manifest(db).path(db).file_stem() == Some(library));
    // If several folders contain a library of this name, the library is unknown.
    <[Project; 1]>::try_from(named).ok().map(|[project]| project)
}

fn add(
    context: &Context<'_>,
    interface: Project,
    target: Project,
    missing: &[(NameKind, SmolStr)],
) -> Option<SourceChange> {
    let db = context.db;
    let names = |kind: NameKind| missing.iter().filter(move |(what, _)| *what == kind).map(|(_, name)| name);
    let data: Vec<NewVariable> = names(NameKind::Data).filter_map(|name| data(context, interface, name)).collect();
    let programs: Vec<NewProgram> =
        names(NameKind::Program).filter_map(|name| program(context, interface, name)).collect();
    let mut change = match programs.as_slice() {
        [] => SourceChange::default(),
        programs => declare::programs(db, target, programs)?,
    };
    if !data.is_empty() {
        change.edits.push(declare::public_data(db, target, &data)?);
    }
    Some(change)
}

fn data(context: &Context<'_>, interface: Project, name: &str) -> Option<NewVariable> {
    let decl = &items(context.db, interface).data.get(name)?.decl;
    let (type_name, sizes) = (decl.type_name.to_string(), decl.sizes.clone());
    Some(NewVariable { name: name.to_owned(), type_name, container: decl.container, sizes })
}

/// An empty program with the same parameters.
fn program(context: &Context<'_>, interface: Project, name: &str) -> Option<NewProgram> {
    let file = *items(context.db, interface).programs.get(name)?;
    let params = header(context.db, file).params.iter().map(|param| {
        let sizes = match param.container {
            Container::Array { dims } => vec![2; usize::from(dims)],
            _ => vec![1],
        };
        let (name, type_name) = (param.name.to_string(), param.type_name.to_string());
        (NewVariable { name, type_name, container: param.container, sizes }, param.by_reference)
    });
    let line_end = context.line_end().trim_start_matches("&#13;");
    Some(NewProgram {
        name: name.to_owned(),
        public: true,
        params: params.collect(),
        line_end,
        ..NewProgram::default()
    })
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const LIBRARIES: &str = "--- part\npublic num nWeight[2]\npublic point pGrip\npublic program pick(num& x_n, string x_s[])\nbegin\nend\n--- bag\npublic num nOther\n";

    #[test]
    fn missing_data_and_programs_are_created() {
        check(
            "add-missing-items",
            &format!(
                "library part \"Disk://part/part.pjx\" autoload=false\nputln(part:libLoad(\"Disk://b$0ag/bag.pjx\"))\npart:nWeight[0]=1\nhere(part:pGrip)\ncall part:pick(part:nWeight[0],\"\")\n{LIBRARIES}"
            ),
            expect![[r#"
                new usrapp/bag/pick.pgx
                +<?xml version="1.0" encoding="utf-8"?>
                +<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
                +  <Program name="pick" access="public">
                +    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
                +      <Parameter name="x_n" type="num" xsi:type="element" use="reference" />
                +      <Parameter name="x_s" type="string" xsi:type="array" use="reference" />
                +    </Parameters>
                +    <Code><![CDATA[begin
                +end]]></Code>
                +  </Program>
                +</Programs>
                usrapp/bag/bag.dtx
                +    <Data name="nWeight" access="public" xsi:type="array" type="num" size="2" />
                +    <Data name="pGrip" access="public" xsi:type="array" type="pointRx" size="1">
                +      <Value key="0" fatherId="world[0]" />
                +    </Data>
                usrapp/bag/bag.pjx
                -  <Programs />
                +  <Programs>
                +    <Program file="pick.pgx" />
                +  </Programs>
            "#]],
        );
    }

    #[test]
    fn nothing_is_offered_if_nothing_is_missing() {
        let listing = format!(
            "library part \"Disk://part/part.pjx\" autoload=false\nputln(part:libLoad(\"Disk://p$0art/part.pjx\"))\npart:nWeight[0]=1\n{LIBRARIES}"
        );
        assert_eq!(offered(&listing, "add-missing-items"), None);
    }
}
