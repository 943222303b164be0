using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A command as menus, buttons and keys have it.</summary>
/// <param name="about">What all faces of the session know about it.</param>
/// <param name="run">Does it.</param>
internal sealed class CommandViewModel(SessionCommand about, Action run) : Observable, ICommand
{
    private bool _isEnabled = true;
    private bool _isOn;

    /// <inheritdoc/>
    public event EventHandler? CanExecuteChanged;

    /// <summary>How programs call it.</summary>
    public string Id => about.Id;

    /// <summary>Its group.</summary>
    public string Group => about.Group;

    /// <summary>What it is called in a menu.</summary>
    public string Name => about.Name;

    /// <summary>What it is called on a button.</summary>
    public string Label => about.Name.Replace(" …", "", StringComparison.Ordinal);

    /// <summary>What it is for, and its keys.</summary>
    public string Tip => about.Keys is null ? about.Tip : $"{about.Tip} ({KeysText})";

    /// <summary>Its keys as they are printed on keyboards; empty where it has none.</summary>
    public string KeysText => about.KeysText ?? "";

    /// <summary>Its icon as SVG writes paths; empty where it has none.</summary>
    public string Icon => about.Icon ?? "";

    /// <summary>Whether it can be done now.</summary>
    public bool IsEnabled
    {
        get => _isEnabled;
        set
        {
            if (Set(ref _isEnabled, value))
            {
                CanExecuteChanged?.Invoke(this, EventArgs.Empty);
            }
        }
    }

    /// <summary>Whether what it switches is on: a tool, a pane.</summary>
    public bool IsOn
    {
        get => _isOn;
        set => Set(ref _isOn, value);
    }

    /// <inheritdoc/>
    public bool CanExecute(object? parameter) => IsEnabled;

    /// <inheritdoc/>
    public void Execute(object? parameter) => run();
}
