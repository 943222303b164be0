namespace RayTracer.Desktop.ViewModels;

/// <summary>Things of one family that can be added.</summary>
/// <param name="Name">The family.</param>
/// <param name="Items">The things.</param>
internal sealed record AddGroup(string Name, IReadOnlyList<AddItem> Items);
