// Messages of the protocol that the server and its clients exchange, by method. messages.js generates the schema from
// these types and validates every recorded message against it.
import type * as p from "vscode-languageserver-protocol";

/** Item of `val3/workspaceTree`. */
interface TreeItem {
  name: string;
  detail: string;
  location: p.Location;
  range: p.Range;
}

interface TreeReference extends TreeItem {
  project: p.DocumentUri | null;
  loaded: p.DocumentUri[];
}

type ProjectKind = "application" | "tests" | "library" | "type";

interface TreeProject {
  name: string;
  uri: p.DocumentUri;
  kind: ProjectKind;
  hasTypes: boolean;
  programs: (TreeItem & { public: boolean; runs: boolean })[];
  data: (TreeItem & { public: boolean; type: string; sizes: p.uinteger[]; isCollection: boolean; value: string | null })[];
  libraries: TreeReference[];
  types: TreeReference[];
}

/** Project in the response to `val3/libraries`. */
interface Candidate {
  uri: p.DocumentUri;
  kind: ProjectKind;
  name: string;
  path: string;
  libraries: string[];
  types: string[];
  publicPrograms: p.uinteger;
  publicData: p.uinteger;
  fits: string[];
  libraryCircle: boolean;
  typeCircle: boolean;
}

export interface Params {
  "val3/workspaceTree": null;
  "val3/libraries": { uri: p.DocumentUri };
  "val3/addLibrary": { uri: p.DocumentUri; kind: "library" | "type"; name: string; path: string };
  "val3/delete": p.TextDocumentPositionParams;
  "initialize": p.InitializeParams;
  "initialized": p.InitializedParams;
  "$/setTrace": p.SetTraceParams;
  "$/cancelRequest": { id: number | string };
  "$/progress": { token: p.ProgressToken; value: p.WorkDoneProgressBegin | p.WorkDoneProgressReport | p.WorkDoneProgressEnd };
  "client/registerCapability": p.RegistrationParams;
  "client/unregisterCapability": p.UnregistrationParams;
  "window/logMessage": p.LogMessageParams;
  "window/showMessage": p.ShowMessageParams;
  "window/workDoneProgress/create": p.WorkDoneProgressCreateParams;
  "workspace/configuration": p.ConfigurationParams;
  "workspace/didChangeConfiguration": p.DidChangeConfigurationParams;
  "workspace/didChangeWatchedFiles": p.DidChangeWatchedFilesParams;
  "workspace/didChangeWorkspaceFolders": p.DidChangeWorkspaceFoldersParams;
  "workspace/applyEdit": p.ApplyWorkspaceEditParams;
  "workspace/symbol": p.WorkspaceSymbolParams;
  "workspaceSymbol/resolve": p.WorkspaceSymbol;
  "workspace/diagnostic": p.WorkspaceDiagnosticParams;
  "workspace/textDocumentContent": p.TextDocumentContentParams;
  "workspace/textDocumentContent/refresh": p.TextDocumentContentRefreshParams;
  "workspace/executeCommand": p.ExecuteCommandParams;
  "workspace/willCreateFiles": p.CreateFilesParams;
  "workspace/didCreateFiles": p.CreateFilesParams;
  "workspace/willRenameFiles": p.RenameFilesParams;
  "workspace/didRenameFiles": p.RenameFilesParams;
  "workspace/willDeleteFiles": p.DeleteFilesParams;
  "workspace/didDeleteFiles": p.DeleteFilesParams;
  "window/workDoneProgress/cancel": p.WorkDoneProgressCancelParams;
  "window/showDocument": p.ShowDocumentParams;
  "$/logTrace": p.LogTraceParams;
  "textDocument/didOpen": p.DidOpenTextDocumentParams;
  "textDocument/didChange": p.DidChangeTextDocumentParams;
  "textDocument/didSave": p.DidSaveTextDocumentParams;
  "textDocument/didClose": p.DidCloseTextDocumentParams;
  "textDocument/publishDiagnostics": p.PublishDiagnosticsParams;
  "textDocument/diagnostic": p.DocumentDiagnosticParams;
  "textDocument/hover": p.HoverParams;
  "textDocument/completion": p.CompletionParams;
  "completionItem/resolve": p.CompletionItem;
  "textDocument/signatureHelp": p.SignatureHelpParams;
  "textDocument/definition": p.DefinitionParams;
  "textDocument/declaration": p.DeclarationParams;
  "textDocument/typeDefinition": p.TypeDefinitionParams;
  "textDocument/implementation": p.ImplementationParams;
  "textDocument/prepareCallHierarchy": p.CallHierarchyPrepareParams;
  "callHierarchy/incomingCalls": p.CallHierarchyIncomingCallsParams;
  "callHierarchy/outgoingCalls": p.CallHierarchyOutgoingCallsParams;
  "textDocument/prepareTypeHierarchy": p.TypeHierarchyPrepareParams;
  "typeHierarchy/supertypes": p.TypeHierarchySupertypesParams;
  "typeHierarchy/subtypes": p.TypeHierarchySubtypesParams;
  "textDocument/codeAction": p.CodeActionParams;
  "codeAction/resolve": p.CodeAction;
  "textDocument/codeLens": p.CodeLensParams;
  "codeLens/resolve": p.CodeLens;
  "textDocument/documentLink": p.DocumentLinkParams;
  "documentLink/resolve": p.DocumentLink;
  "textDocument/inlayHint": p.InlayHintParams;
  "inlayHint/resolve": p.InlayHint;
  "textDocument/linkedEditingRange": p.LinkedEditingRangeParams;
  "textDocument/rangeFormatting": p.DocumentRangeFormattingParams;
  "textDocument/onTypeFormatting": p.DocumentOnTypeFormattingParams;
  "textDocument/references": p.ReferenceParams;
  "textDocument/documentHighlight": p.DocumentHighlightParams;
  "textDocument/documentSymbol": p.DocumentSymbolParams;
  "textDocument/inlineValue": p.InlineValueParams;
  "textDocument/foldingRange": p.FoldingRangeParams;
  "textDocument/selectionRange": p.SelectionRangeParams;
  "textDocument/semanticTokens/full": p.SemanticTokensParams;
  "textDocument/semanticTokens/full/delta": p.SemanticTokensDeltaParams;
  "textDocument/semanticTokens/range": p.SemanticTokensRangeParams;
  "textDocument/formatting": p.DocumentFormattingParams;
  "textDocument/prepareRename": p.PrepareRenameParams;
  "textDocument/rename": p.RenameParams;
  "val3/variables": { uri: string; program?: string | null };
  "val3/editVariables": EditVariablesParams;
  "val3/data": { uri: p.DocumentUri; previousResultId?: string; withoutFindings?: boolean };
  "val3/editData": { uri: p.DocumentUri; version: p.integer | null; edits: DataEdit[]; check?: boolean };
  "val3/dataPoses": { uri: p.DocumentUri; names: string[] };
}

/** Replacement of items in a list. */
interface Replacement<Item> {
  start: p.uinteger;
  deleteCount: p.uinteger;
  items: Item[];
}

/** Difference between two results of `val3/data`. */
export interface DataChanges {
  resultId: string;
  version: p.integer | null;
  problem: string | null;
  data: Replacement<Datum>;
  values: { start: p.uinteger; deleteCount: p.uinteger } | null;
  lineShift: p.integer;
  findings: Replacement<DataFinding> | null;
}

/** A data file as tables. */
export interface DataTables {
  resultId: string;
  version: p.integer | null;
  dialect: "old" | "new";
  problem: string | null;
  types: DataType[];
  data: Datum[];
  findings: DataFinding[];
}

export type DataContainer = "array" | "collection";
export type Access = "public" | "private";

export interface DataType {
  name: string;
  columns: Column[];
  fields: { name: string; type: string; container: DataContainer; size: p.uinteger[] }[];
  containers: DataContainer[];
}

export interface Column {
  id: string;
  title: string;
  unit: string | null;
  kind: "number" | "text" | "bool" | "choice" | "father" | "link";
  choices: string[];
  default: string;
}

/** A variable, or a field without access and range. */
export interface Datum {
  name: string;
  access?: Access;
  type: string;
  container: DataContainer;
  size: p.uinteger[];
  range?: p.Range;
  values: { key: string; texts: (string | null)[]; fields?: Datum[] }[];
}

export interface Place {
  name: string;
  key?: string;
  within?: { name: string; key: string }[];
}

export interface DataFinding {
  place: Place;
  column: string | null;
  severity: "error" | "warning" | "information" | "hint";
  code: string;
  message: string;
}

export type DataEdit =
  | { kind: "set"; cells: { place: Place; column: string; text: string | null }[] }
  | { kind: "add"; name: string; type: string; access: Access; container: DataContainer; size: p.uinteger[]; after?: string | null }
  | { kind: "duplicate"; name: string; as: string }
  | { kind: "delete"; names: string[] }
  | { kind: "access"; names: string[]; access: Access }
  | { kind: "resize"; place: Place; size: p.uinteger[] }
  | { kind: "addKey"; place: Place; key: string }
  | { kind: "removeKey"; place: Place; keys: string[] }
  | { kind: "renameKey"; place: Place; key: string; as: string };

export interface DataPose {
  name: string;
  key: string;
  within?: { name: string; key: string }[];
  world: [number, number, number, number, number, number] | null;
  chain: string;
  reach: "reachable" | "outOfReach" | null;
  why: string | null;
  joints: number[] | null;
}

export interface Results {
  "val3/workspaceTree": TreeProject[];
  "val3/libraries": { hasTypes: boolean; candidates: Candidate[] };
  "val3/addLibrary": p.WorkspaceEdit;
  "val3/delete": { edit: p.WorkspaceEdit; uses: p.Location[] };
  "initialize": p.InitializeResult;
  "shutdown": null;
  "client/registerCapability": null;
  "client/unregisterCapability": null;
  "window/workDoneProgress/create": null;
  "workspace/configuration": p.LSPAny[];
  "workspace/applyEdit": p.ApplyWorkspaceEditResult;
  "workspace/diagnostic/refresh": null;
  "workspace/semanticTokens/refresh": null;
  "workspace/inlayHint/refresh": null;
  "workspace/codeLens/refresh": null;
  "workspace/symbol": p.SymbolInformation[] | p.WorkspaceSymbol[] | null;
  "workspaceSymbol/resolve": p.WorkspaceSymbol;
  "workspace/diagnostic": p.WorkspaceDiagnosticReport;
  "workspace/textDocumentContent": p.TextDocumentContentResult;
  "workspace/textDocumentContent/refresh": null;
  "workspace/executeCommand": p.LSPAny;
  "workspace/willCreateFiles": p.WorkspaceEdit | null;
  "workspace/willRenameFiles": p.WorkspaceEdit | null;
  "workspace/willDeleteFiles": p.WorkspaceEdit | null;
  "window/showDocument": p.ShowDocumentResult;
  "textDocument/diagnostic": p.DocumentDiagnosticReport;
  "textDocument/hover": p.Hover | null;
  "textDocument/completion": p.CompletionItem[] | p.CompletionList | null;
  "completionItem/resolve": p.CompletionItem;
  "textDocument/signatureHelp": p.SignatureHelp | null;
  "textDocument/definition": p.Definition | p.LocationLink[] | null;
  "textDocument/declaration": p.Declaration | p.LocationLink[] | null;
  "textDocument/typeDefinition": p.Definition | p.LocationLink[] | null;
  "textDocument/implementation": p.Definition | p.LocationLink[] | null;
  "textDocument/prepareCallHierarchy": p.CallHierarchyItem[] | null;
  "callHierarchy/incomingCalls": p.CallHierarchyIncomingCall[] | null;
  "callHierarchy/outgoingCalls": p.CallHierarchyOutgoingCall[] | null;
  "textDocument/prepareTypeHierarchy": p.TypeHierarchyItem[] | null;
  "typeHierarchy/supertypes": p.TypeHierarchyItem[] | null;
  "typeHierarchy/subtypes": p.TypeHierarchyItem[] | null;
  "textDocument/codeAction": (p.Command | p.CodeAction)[] | null;
  "codeAction/resolve": p.CodeAction;
  "textDocument/codeLens": p.CodeLens[] | null;
  "codeLens/resolve": p.CodeLens;
  "textDocument/documentLink": p.DocumentLink[] | null;
  "documentLink/resolve": p.DocumentLink;
  "textDocument/inlayHint": p.InlayHint[] | null;
  "inlayHint/resolve": p.InlayHint;
  "textDocument/linkedEditingRange": p.LinkedEditingRanges | null;
  "textDocument/rangeFormatting": p.TextEdit[] | null;
  "textDocument/onTypeFormatting": p.TextEdit[] | null;
  "textDocument/references": p.Location[] | null;
  "textDocument/documentHighlight": p.DocumentHighlight[] | null;
  "textDocument/documentSymbol": p.DocumentSymbol[] | p.SymbolInformation[] | null;
  "textDocument/inlineValue": p.InlineValue[] | null;
  "textDocument/foldingRange": p.FoldingRange[] | null;
  "textDocument/selectionRange": p.SelectionRange[] | null;
  "textDocument/semanticTokens/full": p.SemanticTokens | null;
  "textDocument/semanticTokens/full/delta": p.SemanticTokens | p.SemanticTokensDelta | null;
  "textDocument/semanticTokens/range": p.SemanticTokens | null;
  "textDocument/formatting": p.TextEdit[] | null;
  "textDocument/prepareRename": p.PrepareRenameResult | null;
  "textDocument/rename": p.WorkspaceEdit | null;
  "val3/variables": VariablesResult | null;
  "val3/editVariables": { edit: p.WorkspaceEdit | null; refused: string | null };
  "val3/data": DataTables | DataChanges | null;
  "val3/editData": { edit: p.WorkspaceEdit | null; refused: string | null; findings: DataFinding[] };
  "val3/dataPoses": DataPose[];
}

/** Requests beyond the protocol. */
type Container = "element" | "array" | "collection";
type Passing = "value" | "reference";

interface VariablesResult {
  uri: string;
  version: number | null;
  program: string;
  parameters: { name: string; type: string; container: Container; dimensions: number; passing: Passing; range: p.Range; uses: number }[];
  locals: { name: string; type: string; container: Container; size: number[]; range: p.Range; uses: number }[];
  types: string[];
  isOld: boolean;
  fixed: string | null;
}

interface EditVariablesParams {
  uri: string;
  version: number | null;
  program: string;
  edits: {
    parameters?: { from?: number | null; name: string; type: string; container: Container; dimensions?: number; passing: Passing; argument?: string }[];
    locals?: { from?: number | null; name: string; type: string; size: number[] }[];
  };
}
