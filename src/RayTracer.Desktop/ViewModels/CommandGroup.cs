namespace RayTracer.Desktop.ViewModels;

/// <summary>A menu: commands that belong together.</summary>
/// <param name="Name">What it is called.</param>
/// <param name="Commands">The commands.</param>
internal sealed record CommandGroup(string Name, IReadOnlyList<CommandViewModel> Commands);
