using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A command as menus, buttons and keys have it.</summary>
/// <param name="about">The session's description of the command, which all faces share.</param>
/// <param name="run">Does it.</param>
internal sealed class CommandViewModel(SessionCommand about, Action run) : Observable, ICommand
{
    /// <inheritdoc/>
    public event EventHandler? CanExecuteChanged;

    public string Id => about.Id;

    /// <summary>Its group.</summary>
    public string Group => about.Group;

    /// <summary>The name in menus.</summary>
    public string Name => about.Name;

    /// <summary>The name on buttons.</summary>
    public string Label => about.Name.Replace(" …", "", StringComparison.Ordinal);

    /// <summary>The description, with its keys.</summary>
    public string Tip => about.Keys is null ? about.Tip : $"{about.Tip} ({KeysText})";

    /// <summary>Its keys as they are printed on keyboards; empty where it has none.</summary>
    public string KeysText => about.KeysText ?? "";

    /// <summary>Its icon as SVG writes paths; empty where it has none.</summary>
    public string Icon => about.Icon ?? "";

    public bool IsEnabled
    {
        get;
        set
        {
            if (SetProperty(ref field, value))
            {
                CanExecuteChanged?.Invoke(this, EventArgs.Empty);
            }
        }
    } = true;

    /// <summary>Returns whether what it switches is on: a tool, a pane.</summary>
    public bool IsOn { get; set => SetProperty(ref field, value); }

    /// <inheritdoc/>
    public bool CanExecute(object? parameter) => IsEnabled;

    /// <inheritdoc/>
    public void Execute(object? parameter) => run();
}
