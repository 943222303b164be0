using System.Windows.Input;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A thing that can be added.</summary>
/// <param name="Name">What it is called.</param>
/// <param name="Tip">What it is.</param>
/// <param name="Add">Adds it.</param>
internal sealed record AddItem(string Name, string Tip, ICommand Add);
