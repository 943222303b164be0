namespace RayTracer.Session;

/// <summary>A shipped scene.</summary>
/// <param name="Id">How it is asked for.</param>
/// <param name="Name">What it is called.</param>
/// <param name="Summary">What it shows, from the comment at its head.</param>
public sealed record GalleryItem(string Id, string Name, string Summary);
