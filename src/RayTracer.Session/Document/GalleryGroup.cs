namespace RayTracer.Session;

/// <summary>Shipped scenes that belong together.</summary>
/// <param name="Title">What they are.</param>
/// <param name="Items">The scenes.</param>
public sealed record GalleryGroup(string Title, IReadOnlyList<GalleryItem> Items);
