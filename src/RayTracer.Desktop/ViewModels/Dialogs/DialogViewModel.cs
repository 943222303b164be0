using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A question over the window.</summary>
internal abstract class DialogViewModel : Observable
{
    /// <summary>A dialog that can be closed.</summary>
    protected DialogViewModel() => Cancel = new ActionCommand(() => Close());

    /// <summary>What it is called.</summary>
    public abstract string Title { get; }

    /// <summary>What the button says that leaves all as it is.</summary>
    public virtual string CancelText => SessionTexts.Of("dialogs.cancel");

    /// <summary>Leaves all as it is.</summary>
    public ICommand Cancel { get; }

    /// <summary>Takes it away; set by whoever shows it.</summary>
    public Action Close { get; set; } = () => { };

    /// <summary>A button that does something and closes the dialog.</summary>
    protected ActionCommand Button(Action run) => new(() =>
    {
        Close();
        run();
    });
}

/// <summary>All keys on one sheet.</summary>
internal sealed class ShortcutsViewModel : DialogViewModel
{
    /// <inheritdoc/>
    public override string Title => SessionTexts.Of("shortcuts.title");

    /// <inheritdoc/>
    public override string CancelText => SessionTexts.Of("dialogs.close");

    /// <summary>The keys in groups.</summary>
    public IReadOnlyList<ShortcutGroup> Groups { get; } =
    [
        .. SessionCommand.All.Where(c => c.Keys is not null).GroupBy(c => c.Group)
            .Select(g => new ShortcutGroup(SessionTexts.Of($"groups.{g.Key}"), [.. g.Select(c => new ShortcutRow(c.Name, c.KeysText!))])),
        new(SessionTexts.Of("shortcuts.mouse"), [.. Enumerable.Range(0, SessionTexts.Count("shortcuts.gestures"))
            .Select(i => new ShortcutRow(SessionTexts.Of($"shortcuts.gestures.{i}.1"), SessionTexts.Of($"shortcuts.gestures.{i}.0")))]),
    ];
}

/// <summary>A part of the sheet of keys.</summary>
/// <param name="Title">What it is called.</param>
/// <param name="Rows">Its lines.</param>
internal sealed record ShortcutGroup(string Title, IReadOnlyList<ShortcutRow> Rows);

/// <summary>A line of the sheet of keys.</summary>
/// <param name="What">What happens.</param>
/// <param name="Keys">By which keys or gesture.</param>
internal sealed record ShortcutRow(string What, string Keys);

/// <summary>Asks whether a file may be replaced.</summary>
internal sealed class OverwriteViewModel : DialogViewModel
{
    /// <summary>The question.</summary>
    /// <param name="why">What is in the way.</param>
    /// <param name="go">Replaces it.</param>
    public OverwriteViewModel(string why, Action go)
    {
        Text = why;
        Replace = Button(go);
    }

    /// <inheritdoc/>
    public override string Title => SessionTexts.Of("dialogs.overwriteTitle");

    /// <summary>What is in the way.</summary>
    public string Text { get; }

    /// <summary>Replaces it.</summary>
    public ICommand Replace { get; }
}

/// <summary>Asks what becomes of changes that are not saved.</summary>
internal sealed class UnsavedViewModel : DialogViewModel
{
    /// <summary>The question.</summary>
    /// <param name="name">The document.</param>
    /// <param name="save">Saves it, and tells whether it is saved.</param>
    /// <param name="go">Goes on.</param>
    public UnsavedViewModel(string name, Func<Task<bool>> save, Action go)
    {
        Text = SessionTexts.Of("dialogs.unsaved", name);
        Discard = Button(go);
        Save = Button(() => _ = SaveAndGo(save, go));
    }

    /// <inheritdoc/>
    public override string Title => SessionTexts.Of("dialogs.unsavedTitle");

    /// <summary>The question in words.</summary>
    public string Text { get; }

    /// <summary>Goes on without the changes.</summary>
    public ICommand Discard { get; }

    /// <summary>Saves them first.</summary>
    public ICommand Save { get; }

    private static async Task SaveAndGo(Func<Task<bool>> save, Action go)
    {
        if (await save())
        {
            go();
        }
    }
}

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
