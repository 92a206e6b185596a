//! A client with one open program, and requests about that program.

use serde_json::{Value, json};

use crate::cell::{Cell, place};
use crate::client::{Client, at, uri};

pub const START: &str = "usrapp/main/start.pgx";

pub struct Session {
    pub cell: Cell,
    pub client: Client,
}

impl Session {
    pub fn of(listing: &str, abilities: Value) -> Self {
        Self::with(listing, abilities, Value::Null)
    }

    pub fn with(listing: &str, abilities: Value, options: Value) -> Self {
        let cell = Cell::new(listing);
        let mut client = Client::start_with(&[&cell.folder()], abilities, options);
        client.open(&cell.path(START), cell.text(START));
        Self { cell, client }
    }

    /// Position of the first occurrence of `part` in `start`.
    pub fn place(&self, part: &str) -> Value {
        self.place_in(START, part)
    }

    /// Position of the first occurrence of `part` in a file.
    pub fn place_in(&self, file: &str, part: &str) -> Value {
        let (line, column) = place(self.cell.text(file), part);
        at(&self.cell.path(file), line, column)
    }

    /// Sends a request for the first occurrence of `part` in `start`.
    #[track_caller]
    pub fn ask_at(&mut self, method: &str, part: &str) -> Value {
        let place = self.place(part);
        self.client.ask(method, place)
    }

    /// Sends a request for the document `start`.
    #[track_caller]
    pub fn ask(&mut self, method: &str) -> Value {
        let params = json!({ "textDocument": { "uri": uri(&self.cell.path(START)) } });
        self.client.ask(method, params)
    }

    /// Requests code actions at the first occurrence of `part` in `start`.
    #[track_caller]
    pub fn actions_at(&mut self, part: &str, only: Value) -> Value {
        self.actions_in(START, part, only)
    }

    /// Like [`actions_at`](Self::actions_at), in another file.
    #[track_caller]
    pub fn actions_in(&mut self, file: &str, part: &str, only: Value) -> Value {
        let mut params = self.place_in(file, part);
        let place = params["position"].take();
        params["range"] = json!({ "start": place, "end": place });
        params["context"] = json!({ "diagnostics": [], "only": only });
        self.client.ask("textDocument/codeAction", params)
    }
}

/// Strings under `key` in each element of a list.
#[track_caller]
pub fn each<'v>(list: &'v Value, key: &str) -> Vec<&'v str> {
    let list = list.as_array().unwrap_or_else(|| panic!("no list: {list}"));
    list.iter().map(|found| found[key].as_str().unwrap_or("")).collect()
}

/// Element of a list in which `key` has this value.
#[track_caller]
pub fn find(list: &Value, key: &str, wanted: &str) -> Value {
    let found = list.as_array().and_then(|list| list.iter().find(|found| found[key] == wanted));
    found.unwrap_or_else(|| panic!("no {wanted} in {list}")).clone()
}
