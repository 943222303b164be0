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
