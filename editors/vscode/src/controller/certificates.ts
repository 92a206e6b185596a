// Certificates of controllers with TLS. `val3 pull` remembers an accepted one in the project.

import * as vscode from "vscode";

const ACCEPT = "It Is the Same: Accept";

/** Asks whether the fingerprint is that of the controller. Nothing was sent to the controller yet. */
export async function confirmCertificate(address: string, fingerprint: string): Promise<boolean> {
  const detail = `Its fingerprint is\n${fingerprint}\n\nCompare it with the certificate on the controller. If it is another one, another `
    + "device may be answering. The fingerprint is remembered, and another certificate is rejected from then on.";
  return (await vscode.window.showWarningMessage(`The certificate of ${address} is not known.`, { modal: true, detail }, ACCEPT)) === ACCEPT;
}
