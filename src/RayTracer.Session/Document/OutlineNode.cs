namespace RayTracer.Session;

/// <summary>A thing in the outline of a scene.</summary>
/// <param name="Pointer">Where it stands.</param>
/// <param name="Name">What it is called.</param>
/// <param name="Type">Its type in scene files.</param>
/// <param name="Summary">A few words about it.</param>
/// <param name="IsLight">Whether it shines.</param>
/// <param name="Color">Its main colour as #rrggbb (sRGB); null where it has none.</param>
/// <param name="Children">What it consists of.</param>
public sealed record OutlineNode(string Pointer, string Name, string Type, string Summary, bool IsLight, string? Color, IReadOnlyList<OutlineNode> Children);
