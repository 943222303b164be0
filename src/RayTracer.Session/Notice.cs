namespace RayTracer.Session;

/// <summary>Something to tell the user once.</summary>
/// <param name="Id">Grows with each notice.</param>
/// <param name="Kind">"info" or "error".</param>
/// <param name="Text">A sentence, without a final stop.</param>
public sealed record Notice(int Id, string Kind, string Text);
