using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

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
