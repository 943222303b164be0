namespace RayTracer.Desktop.ViewModels;

/// <summary>Shipped scenes that belong together.</summary>
/// <param name="Title">What they are.</param>
/// <param name="Items">The scenes.</param>
internal sealed record GalleryGroupViewModel(string Title, IReadOnlyList<GalleryItemViewModel> Items);
