using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Asks for a thing's new name.</summary>
internal sealed class RenameViewModel : DialogViewModel
{
    private string _name;

    /// <summary>The question.</summary>
    /// <param name="name">The name so far.</param>
    /// <param name="rename">Told the new one.</param>
    public RenameViewModel(string name, Action<string> rename)
    {
        _name = name;
        Rename = Button(() => rename(_name));
    }

    /// <inheritdoc/>
    public override string Title => SessionTexts.Of("dialogs.renameTitle");

    /// <summary>The new name.</summary>
    public string Name
    {
        get => _name;
        set => Set(ref _name, value ?? "");
    }

    /// <summary>Takes it.</summary>
    public ICommand Rename { get; }
}
