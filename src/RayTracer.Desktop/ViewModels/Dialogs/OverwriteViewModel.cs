using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

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
