//! The tools, one per file.

mod check;
mod eval;
mod explain;
mod outline;
mod rename;
mod run;
mod test;
mod write_data;
mod write_program;

pub(crate) use explain::{GUIDE, page};

use crate::tool::{Effect, Tool};

/// Returns the tools in the order of the list. Tools that change files are included only if `may_write`.
pub(crate) fn all(may_write: bool) -> Vec<Tool> {
    let tools = [
        Tool::of::<outline::Outline>(),
        Tool::of::<explain::Explain>(),
        Tool::of::<check::Check>(),
        Tool::of::<eval::Eval>(),
        Tool::of::<run::Run>(),
        Tool::of::<test::Test>(),
        Tool::of::<write_program::WriteProgram>(),
        Tool::of::<write_data::WriteData>(),
        Tool::of::<rename::Rename>(),
    ];
    tools.into_iter().filter(|tool| may_write || tool.effect == Effect::Reads).collect()
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use serde_json::{Value, json};

    use super::*;
    use crate::command::{CommandEnd, CommandOutput};
    use crate::testing::{Folder, call};

    /// Descriptions and schemas of the tools as received by a client, without annotations.
    fn listed() -> Value {
        let tool =
            |tool: Tool| json!({ "name": tool.name, "description": tool.description, "inputSchema": tool.schema });
        all(true).into_iter().map(tool).collect()
    }

    #[test]
    fn tools_that_change_files_need_permission() {
        let names = |may_write: bool| all(may_write).iter().map(|tool| tool.name).collect::<Vec<_>>();
        let (everything, without_changes) = (names(true), names(false));
        assert!(["check", "run"].iter().all(|name| without_changes.contains(name)), "{without_changes:?}");
        for name in ["write_program", "write_data", "rename"] {
            assert!(everything.contains(&name) && !without_changes.contains(&name), "{name}");
        }
    }

    #[test]
    fn the_list_fits_its_budget() {
        // Titles and annotations add about 150 bytes per tool.
        let bytes = listed().to_string().len() + all(true).len() * 150;
        assert!(bytes <= 9_000, "{bytes}");
    }

    #[test]
    fn every_schema_is_one_that_clients_accept() {
        for tool in all(true) {
            let schema = Value::Object(tool.schema.clone());
            assert_eq!(schema["type"], "object", "{}", tool.name);
            assert_eq!(schema["additionalProperties"], false, "{}", tool.name);
            for (name, property) in schema["properties"].as_object().unwrap() {
                assert!(property["description"].is_string(), "{}.{name} has no description", tool.name);
                assert!(property["type"].is_string(), "{}.{name} has no single type: {property}", tool.name);
                assert!(property["type"] != "array" || property["items"].is_object(), "{}.{name}", tool.name);
            }
            let text = schema.to_string();
            assert!(!text.contains("$ref") && !text.contains("\"null\"") && !text.contains("anyOf"), "{text}");
        }
    }

    /// Error of a call with these arguments, returned before a command is started.
    fn refused(name: &str, arguments: Value) -> String {
        let tool = all(true).into_iter().find(|tool| tool.name == name).unwrap();
        let unexpected = Err(CommandEnd::Start("no command was expected".to_owned()));
        call(&Folder::new(&[]), &tool, arguments, unexpected).unwrap_err().0
    }

    #[test]
    fn wrong_arguments_are_refused_with_the_right_form() {
        expect![[r#"the arguments of `explain` are wrong: missing field `topic`. Write {"detail": boolean, "topic": string (required)}"#]]
            .assert_eq(&refused("explain", json!({})));
        expect![[r#"the arguments of `explain` are wrong: unknown field `word`, expected `topic` or `detail`. Write {"detail": boolean, "topic": string (required)}"#]]
            .assert_eq(&refused("explain", json!({ "word": "movej" })));
        expect![[r#"the arguments of `explain` are wrong: invalid type: integer `3`, expected a string. Write {"detail": boolean, "topic": string (required)}"#]]
            .assert_eq(&refused("explain", json!({ "topic": 3 })));
    }

    /// Result of a tool whose command ends with this exit code and output.
    fn answered(name: &str, exit_code: i32, text: &str, messages: &str) -> Result<String, String> {
        let tool = all(true).into_iter().find(|tool| tool.name == name).unwrap();
        let arguments = if name == "explain" { json!({ "topic": "movej" }) } else { json!({}) };
        let output = CommandOutput { exit_code, text: text.to_owned(), messages: messages.to_owned() };
        let answer = call(&Folder::new(&[]), &tool, arguments, Ok(output));
        answer.map(|answer| answer.limited_text()).map_err(|refusal| refusal.0)
    }

    #[test]
    fn a_report_is_an_answer_even_if_the_command_could_not_read_everything() {
        let failure = json!({ "message": "unknown field `xyz`", "places": [] });
        let test = json!({ "id": "palletiser:zz", "seconds": 0, "failure": failure });
        let document = json!({ "passed": 2, "failed": 1, "skipped": 0, "tests": [test] }).to_string();
        expect![[r"
            not ok: 2 passed, 1 failed

            palletiser:zz failed after 0 s: unknown field `xyz`

            note: the folder has a link"]]
        .assert_eq(&answered("test", 2, &document, "note: the folder has a link\n").unwrap());
        let summary = json!({ "errors": 0, "warnings": 0, "infos": 0, "applications": 1, "programs": 2 });
        let document = json!({ "summary": summary, "diagnostics": [] }).to_string();
        expect![[r"
            not ok: 0 errors, 0 warnings, 0 infos in 1 project, 2 programs

            error: cannot read `a.pgx`"]]
        .assert_eq(&answered("check", 2, &document, "error: cannot read `a.pgx`").unwrap());
    }

    #[test]
    fn a_command_without_a_report_is_refused_with_its_messages() {
        for name in ["test", "check", "explain"] {
            let refusal = answered(name, 2, "", "error: there is no test `zz`\n").unwrap_err();
            assert_eq!(refusal, "error: there is no test `zz`", "{name}");
            let refusal = answered(name, 0, "no document", "note").unwrap_err();
            assert!(refusal.starts_with("the output of the command cannot be read") && refusal.ends_with("note"));
        }
    }
}
