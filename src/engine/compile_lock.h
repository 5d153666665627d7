// One model is compiled at a time: MuJoCo's compiler has a lock for the whole process anyway, which printing its schema
// takes as well. Ours lets fork() wait until nobody is in there, because a child has only the thread that forked, and
// would never see MuJoCo's lock open.
#pragma once

namespace mimo::engine {

class CompileLock {
 public:
  // Throws Status::kForked in a child of a process that compiled for longer than fork() waits.
  CompileLock();
  ~CompileLock();
  CompileLock(const CompileLock&) = delete;
  CompileLock& operator=(const CompileLock&) = delete;
};

}  // namespace mimo::engine
