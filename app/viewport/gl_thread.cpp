// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gl_thread.h"

#include <QOpenGLContext>
#include <exception>

#include "app/viewport/background.h"
#include "app/viewport/gl_program.h"
#include "core/base/error.h"

namespace etak {

GlThread::GlThread() : context_(std::make_unique<QOpenGLContext>()) {}

std::unique_ptr<GlThread> GlThread::beside(QOpenGLContext& other) {
  if (!QOpenGLContext::supportsThreadedOpenGL()) return nullptr;
  std::unique_ptr<GlThread> out(new GlThread);
  out->context_->setFormat(other.format());
  out->context_->setShareContext(&other);
  if (!out->context_->create() || !QOpenGLContext::areSharing(out->context_.get(), &other)) return nullptr;
  // On some systems surfaces are windows, which only the user-interface thread may make.
  out->surface_.setFormat(out->context_->format());
  out->surface_.create();
  if (!out->surface_.isValid()) return nullptr;
  out->context_->moveToThread(&out->thread_);
  out->hand_.moveToThread(&out->thread_);
  out->thread_.start();
  return out;
}

GlThread::~GlThread() {
  if (!thread_.isRunning()) return;
  QMetaObject::invokeMethod(
      &hand_,
      [this, home = QThread::currentThread()] {
        context_->makeCurrent(&surface_);
        frames_.reset();
        context_->doneCurrent();
        context_->moveToThread(home);
        hand_.moveToThread(home);
        thread_.quit();
      },
      Qt::QueuedConnection);
  thread_.wait();
}

GlFrames& GlThread::frames() {
  if (!frames_) frames_ = std::make_unique<GlFrames>(true);
  return *frames_;
}

void GlThread::draw(const GlJob& job, std::function<void(const GlFrame&)> done) {
  QMetaObject::invokeMethod(
      &hand_,
      [this, job, done = std::move(done)] {
        GlFrame frame;
        const QString failure = failure_of([&] {
          if (!context_->makeCurrent(&surface_)) {
            frame.context_lost = true;
            return;
          }
          if (job.after != nullptr) {
            Gl& gl = current_gl();
            gl.glWaitSync(job.after, 0, GL_TIMEOUT_IGNORED);
            gl.glDeleteSync(job.after);
          }
          frame = frames().draw(job);
        });
        if (!failure.isEmpty()) frame.failed = failure;
        QMetaObject::invokeMethod(
            this, [frame, done] { done(frame); }, Qt::QueuedConnection);
      },
      Qt::QueuedConnection);
}

QImage GlThread::picture(const GlJob& job) {
  QImage out;
  std::exception_ptr failure;
  QMetaObject::invokeMethod(
      &hand_,
      [&] {
        try {
          if (!context_->makeCurrent(&surface_)) throw Error::at("OpenGL", "the context is gone");
          out = frames().picture(job);
        } catch (...) {
          failure = std::current_exception();
        }
      },
      Qt::BlockingQueuedConnection);
  if (failure) std::rethrow_exception(failure);
  return out;
}

}  // namespace etak
