namespace RayTracer.Session;

/// <summary>A file in a dialog.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Size">Its length in bytes.</param>
/// <param name="Time">When it was written.</param>
public sealed record ListedFile(string Name, long Size, DateTime Time);
