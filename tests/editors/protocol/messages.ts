// The messages of the protocol that the server and its clients exchange, by their methods: from these types the schema
// is made that messages.js holds every recorded message against.
import type * as p from "vscode-languageserver-protocol";

export interface Params {
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
  "textDocument/references": p.ReferenceParams;
  "textDocument/documentHighlight": p.DocumentHighlightParams;
  "textDocument/documentSymbol": p.DocumentSymbolParams;
  "textDocument/foldingRange": p.FoldingRangeParams;
  "textDocument/selectionRange": p.SelectionRangeParams;
  "textDocument/semanticTokens/full": p.SemanticTokensParams;
  "textDocument/semanticTokens/full/delta": p.SemanticTokensDeltaParams;
  "textDocument/semanticTokens/range": p.SemanticTokensRangeParams;
  "textDocument/formatting": p.DocumentFormattingParams;
  "textDocument/prepareRename": p.PrepareRenameParams;
  "textDocument/rename": p.RenameParams;
}

export interface Results {
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
  "textDocument/diagnostic": p.DocumentDiagnosticReport;
  "textDocument/hover": p.Hover | null;
  "textDocument/completion": p.CompletionItem[] | p.CompletionList | null;
  "completionItem/resolve": p.CompletionItem;
  "textDocument/signatureHelp": p.SignatureHelp | null;
  "textDocument/definition": p.Definition | p.LocationLink[] | null;
  "textDocument/references": p.Location[] | null;
  "textDocument/documentHighlight": p.DocumentHighlight[] | null;
  "textDocument/documentSymbol": p.DocumentSymbol[] | p.SymbolInformation[] | null;
  "textDocument/foldingRange": p.FoldingRange[] | null;
  "textDocument/selectionRange": p.SelectionRange[] | null;
  "textDocument/semanticTokens/full": p.SemanticTokens | null;
  "textDocument/semanticTokens/full/delta": p.SemanticTokens | p.SemanticTokensDelta | null;
  "textDocument/semanticTokens/range": p.SemanticTokens | null;
  "textDocument/formatting": p.TextEdit[] | null;
  "textDocument/prepareRename": p.PrepareRenameResult | null;
  "textDocument/rename": p.WorkspaceEdit | null;
}
