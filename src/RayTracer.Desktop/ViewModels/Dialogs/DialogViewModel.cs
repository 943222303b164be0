using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A question over the window.</summary>
internal abstract class DialogViewModel : Observable
{
    public abstract string Title { get; }

    /// <summary>The text of the button that closes the dialog.</summary>
    public virtual string CancelText => SessionTexts.Of("dialogs.cancel");

    /// <summary>Leaves all as it is.</summary>
    public ICommand Cancel => field ??= new RelayCommand(() => Close());

    /// <summary>Takes it away; set by the window that shows it.</summary>
    public Action Close { get; set; } = () => { };

    /// <summary>A button that does something and closes the dialog.</summary>
    protected RelayCommand Button(Action run) => new(() =>
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
/// <param name="Title">The title.</param>
/// <param name="Rows">Its lines.</param>
internal sealed record ShortcutGroup(string Title, IReadOnlyList<ShortcutRow> Rows);

/// <summary>A line of the sheet of keys.</summary>
/// <param name="What">The action.</param>
/// <param name="Keys">By which keys or gesture.</param>
internal sealed record ShortcutRow(string What, string Keys);

/// <summary>Asks whether a file may be replaced.</summary>
/// <param name="why">The reason not to.</param>
/// <param name="go">Replaces it.</param>
internal sealed class OverwriteViewModel(string why, Action go) : DialogViewModel
{
    /// <inheritdoc/>
    public override string Title => SessionTexts.Of("dialogs.overwriteTitle");

    /// <summary>The reason not to.</summary>
    public string Text => why;

    /// <summary>Replaces it.</summary>
    public ICommand Replace => field ??= Button(go);
}

/// <summary>Asks what becomes of changes that are not saved.</summary>
/// <param name="name">The document.</param>
/// <param name="save">Saves it, and returns whether it is saved.</param>
/// <param name="go">Continues.</param>
internal sealed class UnsavedViewModel(string name, Func<Task<bool>> save, Action go) : DialogViewModel
{
    /// <inheritdoc/>
    public override string Title => SessionTexts.Of("dialogs.unsavedTitle");

    /// <summary>The question in words.</summary>
    public string Text => SessionTexts.Of("dialogs.unsaved", name);

    /// <summary>Continues without the changes.</summary>
    public ICommand Discard => field ??= Button(go);

    /// <summary>Saves them first.</summary>
    public ICommand Save => field ??= Button(() => _ = SaveAndGo());

    private async Task SaveAndGo()
    {
        if (await save())
        {
            go();
        }
    }
}

/// <summary>Asks for a thing's new name.</summary>
/// <param name="name">The name so far.</param>
/// <param name="rename">Takes the new one.</param>
internal sealed class RenameViewModel(string name, Action<string> rename) : DialogViewModel
{
    /// <inheritdoc/>
    public override string Title => SessionTexts.Of("dialogs.renameTitle");

    /// <summary>The new name.</summary>
    public string Name { get; set => SetProperty(ref field, value ?? ""); } = name;

    /// <summary>Takes it.</summary>
    public ICommand Rename => field ??= Button(() => rename(Name));
}
