/**
 * Tests find things by role and name. There is no `data-testid` so far; these attributes say what no role can:
 *
 * - canvas.picture: `data-painted` (frames painted so far), `data-version`, `data-samples` and `data-preview` of the newest one
 * - [role=treeitem]: `data-pointer`, the JSON pointer of the thing
 * - .gizmo [data-handle]: "x", "y", "z" or "all"; they have roles and names too
 */
export {};
